// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/metadata.h"
#include "plugins/api/parameter.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <Eigen/Core>

#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QObject;
class QWidget;

namespace tetra {

/// What of an editor's surroundings has changed.
enum class EditorChange {
    Model,     ///< another one is open, or none: all is new
    Value,     ///< of a parameter, by whatever hand; or another mode, which may have other parameters
    Isovalues, ///< one or all of them
    Mesh,      ///< and with it the histogram
    Picked,    ///< the value that was picked in the picture
};

/// A value of the data that was pointed at in the picture, and where it was seen; both in the units of the dataset.
struct PickedValue {
    double value = 0;
    Eigen::Vector3d place{0, 0, 0};
    bool onSurface = false; ///< of that isovalue; else in the volume or on its boundary
    bool operator==(const PickedValue&) const = default;
};

/// Which file an editor wants to read or write.
struct EditorFile {
    QString dialog; ///< object name of the window's dialog
    QString title;
    QString filter; ///< "Transfer functions (*.json)"
    QString ending; ///< of a file to write, behind the model's name: "-transfer.json"
};

/// The window, as an editor sees it (R18): what there is to edit, and who takes the edits. Each edit is one undo step
/// of the window; edits between beginGesture() and endGesture() (a drag, a held key) are one together. An edit that is
/// not valid changes nothing. Lives longer than the editor's widget; used in the GUI thread only.
class EditorHost {
public:
    virtual ~EditorHost() = default;

    /// What the present way of looking at the model has of the type that the editor edits, as far as it matters: which
    /// values it may edit. Labels and explanations are in the user's language.
    virtual std::vector<Parameter> parameters() const = 0;
    /// The value of a parameter; its default as long as nobody has chosen one. Valid until the next change. A
    /// "transfer" (plugins/api/scene_parameters.h) there is always, whether it is seen or not.
    virtual const ParameterValue& value(const std::string& id) const = 0;
    /// Proposes another one, of the same type.
    virtual void setValue(const std::string& id, const ParameterValue& value) = 0;
    /// Of several parameters the user has chosen this one to edit: what the window itself does to a transfer function,
    /// by a drag in the picture or by a key, is done to this one as long as the mode has it.
    virtual void setEdited(const std::string& id) = 0;
    virtual void beginGesture() = 0;
    virtual void endGesture() = 0;
    /// Calls `call` after every change, as long as `receiver` lives.
    virtual void whenChanged(QObject* receiver, const std::function<void(EditorChange)>& call) = 0;

    virtual bool hasModel() const = 0;
    /// Of the model's values; empty without a model.
    virtual ValueRange range() const = 0;
    /// Of the domain, in the units of the dataset; 0 without a model.
    virtual double diagonal() const = 0;
    /// How often values occur in the mesh of the picture; none before the first one.
    virtual std::shared_ptr<const ValueHistogram> histogram() const = 0;
    /// The same of the values' natural logarithms, for an axis that goes by them; none if not all values are positive.
    virtual std::shared_ptr<const ValueHistogram> logarithmicHistogram() const = 0;

    virtual const std::vector<Isovalue>& isovalues() const = 0;
    /// In a colour that is not in use yet.
    virtual void addIsovalue(double value) = 0;
    virtual void setIsovalue(std::size_t index, const Isovalue& isovalue) = 0;
    virtual void removeIsovalue(std::size_t index) = 0;

    /// Lets the user choose a file and gives its text to `use`; what that says against it is told with the file's name.
    virtual void loadText(QWidget* parent, const EditorFile& file,
                          const std::function<Status(const std::string& text)>& use) = 0;
    /// Lets the user choose where to, and writes what `make` makes of the file's name without its ending.
    virtual void saveText(QWidget* parent, const EditorFile& file,
                          const std::function<std::string(const std::string& name)>& make) = 0;
    /// A message in the window: what went wrong, and what to do.
    virtual void tell(const Message& message) = 0;

    /// None before the user picks one, and after the mark was taken away. It stays what it is when isovalues or the
    /// mesh change.
    virtual std::optional<PickedValue> picked() const = 0;
    /// Takes the mark away, here and in the picture.
    virtual void forgetPicked() = 0;
};

/// A widget over the parameters of one type, which the plugin's metadata name ("edits"). It gets a dock of its own,
/// which has the metadata's title and is called dock.ID.
class Editor {
public:
    virtual ~Editor() = default;
    /// The caller owns the widget, which shows what `host` has and holds no value of its own.
    virtual QWidget* makeWidget(EditorHost& host) const = 0;
};

template <> inline constexpr std::string_view qtOf<Editor> = QT_VERSION_STR;

} // namespace tetra
