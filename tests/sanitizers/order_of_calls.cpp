// SPDX-License-Identifier: GPL-3.0-or-later
/// The order of posted calls, for the thread sanitizer alone: Qt's libraries are not compiled for it, so that it would
/// take each call that one thread posts to another for a race. What comes before QMetaObject::invokeMethod() comes
/// before the call. This function takes the place of Qt's, and calls it.
#include "tests/sanitizers/next_function.h"

#include <QObject>

#include <sanitizer/tsan_interface.h>

namespace {

/// Does a call in the order described.
class OrderedCall : public QtPrivate::QSlotObjectBase {
public:
    explicit OrderedCall(QSlotObjectBase* call) : QSlotObjectBase(&happen), call_(call) { __tsan_release(this); }

private:
    static void happen(int what, QSlotObjectBase* base, QObject* receiver, void** arguments, bool* isSame)
    {
        __tsan_acquire(base);
        auto* const ordered = static_cast<OrderedCall*>(base);
        if (what == Call)
            ordered->call_->call(receiver, arguments);
        if (what == Compare)
            *isSame = ordered->call_->compare(arguments);
        if (what == Destroy) {
            ordered->call_->destroyIfLastRef();
            delete ordered;
        }
    }

    QSlotObjectBase* call_;
};

} // namespace

bool QMetaObject::invokeMethodImpl(QObject* object, QtPrivate::QSlotObjectBase* slot, Qt::ConnectionType type,
                                   void* result)
{
    using Function = bool(QObject*, QtPrivate::QSlotObjectBase*, Qt::ConnectionType, void*);
    static auto* const call = tetra::nextFunction<Function>(
        "_ZN11QMetaObject16invokeMethodImplEP7QObjectPN9QtPrivate15QSlotObjectBaseEN2Qt14ConnectionTypeEPv");
    return call(object, new OrderedCall(slot), type, result);
}
