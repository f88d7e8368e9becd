// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/view_state.h"

#include <QCoreApplication>
#include <QUndoCommand>

#include <optional>

namespace tetra {

/// The ids by which the undo stack merges commands; zero is "never".
enum class CommandId { ChangeQuery = 1, ChangeIsovalue, ChangeLook, ChangeView, ChangeAnimation };

/// The number of a gesture (one drag): commands of one gesture merge into one step. Zero is no gesture.
using Gesture = std::uint64_t;

/// Which mesh is seen. Named after what differs.
class ChangeQuery : public QUndoCommand {
    Q_DECLARE_TR_FUNCTIONS(ChangeQuery)
public:
    ChangeQuery(ViewState& state, const QueryState& after, Gesture gesture);
    int id() const override { return static_cast<int>(CommandId::ChangeQuery); }
    void redo() override { state_.setQuery(after_); }
    void undo() override { state_.setQuery(before_); }
    bool mergeWith(const QUndoCommand* next) override;

private:
    static QString nameOf(const QueryState& before, const QueryState& after);

    ViewState& state_;
    QueryState before_;
    QueryState after_;
    Gesture gesture_;
};

/// The parts of a look that an edit is about: a long history keeps no more.
struct LookParts {
    std::optional<std::string> mode;
    std::optional<TransferFunction> transfer;
    std::optional<ParameterValues> settings;
    bool operator==(const LookParts&) const = default;

    /// What of `look` differs from `other`.
    static LookParts difference(const Look& look, const Look& other);
    Look putInto(Look look) const;
    /// With the parts of `others` that it has not.
    void complete(const LookParts& others);
};

/// How the mesh is looked at. Named after what differs.
class ChangeLook : public QUndoCommand {
    Q_DECLARE_TR_FUNCTIONS(ChangeLook)
public:
    ChangeLook(ViewState& state, const Look& after, Gesture gesture);
    int id() const override { return static_cast<int>(CommandId::ChangeLook); }
    void redo() override { state_.setLook(after_.putInto(state_.look())); }
    void undo() override { state_.setLook(before_.putInto(state_.look())); }
    bool mergeWith(const QUndoCommand* next) override;
    bool changesTransfer() const noexcept { return before_.transfer.has_value(); }

private:
    static QString nameOf(const Look& before, const Look& after);

    ViewState& state_;
    LookParts before_;
    LookParts after_;
    Gesture gesture_;
};

/// What is written over the picture.
class ChangeAnnotations : public QUndoCommand {
    Q_DECLARE_TR_FUNCTIONS(ChangeAnnotations)
public:
    ChangeAnnotations(ViewState& state, const AnnotationState& after);
    void redo() override { state_.setAnnotations(after_); }
    void undo() override { state_.setAnnotations(before_); }

private:
    ViewState& state_;
    AnnotationState before_;
    AnnotationState after_;
};

/// The film.
class ChangeAnimation : public QUndoCommand {
    Q_DECLARE_TR_FUNCTIONS(ChangeAnimation)
public:
    ChangeAnimation(ViewState& state, Animation after, Gesture gesture);
    int id() const override { return static_cast<int>(CommandId::ChangeAnimation); }
    void redo() override { state_.setAnimation(after_); }
    void undo() override { state_.setAnimation(before_); }
    bool mergeWith(const QUndoCommand* next) override;

private:
    ViewState& state_;
    Animation before_;
    Animation after_;
    Gesture gesture_;
};

class ChangeIsovalue : public QUndoCommand {
    Q_DECLARE_TR_FUNCTIONS(ChangeIsovalue)
public:
    ChangeIsovalue(ViewState& state, int index, const Isovalue& isovalue, Gesture gesture);
    int id() const override { return static_cast<int>(CommandId::ChangeIsovalue); }
    void redo() override { state_.setIsovalue(index_, after_); }
    void undo() override { state_.setIsovalue(index_, before_); }
    bool mergeWith(const QUndoCommand* next) override;

private:
    ViewState& state_;
    int index_;
    Isovalue before_;
    Isovalue after_;
    Gesture gesture_;
};

class AddIsovalue : public QUndoCommand {
    Q_DECLARE_TR_FUNCTIONS(AddIsovalue)
public:
    AddIsovalue(ViewState& state, const Isovalue& isovalue);
    void redo() override { state_.insertIsovalue(index_, isovalue_); }
    void undo() override { state_.removeIsovalue(index_); }

private:
    ViewState& state_;
    int index_;
    Isovalue isovalue_;
};

class RemoveIsovalue : public QUndoCommand {
    Q_DECLARE_TR_FUNCTIONS(RemoveIsovalue)
public:
    RemoveIsovalue(ViewState& state, int index);
    void redo() override { state_.removeIsovalue(index_); }
    void undo() override { state_.insertIsovalue(index_, isovalue_); }

private:
    ViewState& state_;
    int index_;
    Isovalue isovalue_;
};

} // namespace tetra
