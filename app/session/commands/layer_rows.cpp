// Rows that work on the layer that is painted on.
#include "app/session/commands/session_rows.h"

#include "app/session/commands/selection_commands.h"
#include "app/session/current_layer.h"
#include "undo/layers/merge_layers.h"

#include <algorithm>

namespace suffuse {

namespace {

constexpr int saidMs = 5000; ///< how long the status bar says why nothing was done, or what was lost

/// The group that is the layer; null where there is none yet.
const Group *layerOf(Editor &editor)
{
    return editor.unsettled().painting()->findGroup(editor.layer().group());
}

QString whyNotMerged(NotMerged why)
{
    switch (why) {
    case NotMerged::NothingBelow:
        return Commands::tr("Not merged: nothing lies below the layer in its group.");
    case NotMerged::NoGroupBelow:
        return Commands::tr("Not merged: what lies just below the layer is no layer.");
    case NotMerged::Hidden:
        return Commands::tr("Not merged: one of the two layers is hidden.");
    case NotMerged::Locked:
        return Commands::tr("Not merged: one of the two layers is locked.");
    case NotMerged::Mask:
        return Commands::tr("Not merged: one of the two layers is a mask, and the picture would change.");
    case NotMerged::Clipped:
        return Commands::tr("Not merged: the layer below is clipped, and the picture would change.");
    case NotMerged::ClippedTo:
        return Commands::tr("Not merged: what lies above is clipped to this layer, and the picture would change.");
    case NotMerged::Merged:
        break;
    }
    return {};
}

/// Returns what to say of it, or nothing.
QString mergeLayerDown(Editor &editor)
{
    const QString name = editor.layer().title();
    MergedDown merged = mergeDown(editor.document(), editor.layer().group());
    if (merged.why != NotMerged::Merged)
        return whyNotMerged(merged.why);
    editor.push(std::move(merged.edit), Commands::tr("Merge layer down"));
    editor.layer().chooseByStep(merged.below);
    return merged.keepsGroup ? Commands::tr("So that the picture stays, %1 is a group of its own within %2.")
                                   .arg(name, editor.layer().title())
                             : QString();
}

void duplicateLayer(Editor &editor)
{
    GroupId copy = 0;
    const QString name = nameOfCopy(editor.document().painting()->groups, editor.layer().title());
    editor.push(duplicateGroup(editor.document(), editor.layer().group(), name, copy), Commands::tr("Duplicate layer"));
    if (copy != 0)
        editor.layer().chooseByStep(copy);
}

QString moveLayer(Editor &editor, bool up)
{
    Edit edit = moveGroup(editor.document(), editor.layer().group(), up);
    if (edit.isEmpty())
        return Commands::tr("Nothing changes.");
    editor.push(std::move(edit), up ? Commands::tr("Raise layer") : Commands::tr("Lower layer"));
    return {};
}

/// Above the topmost layer there is none, which means that paint goes on top of all.
void stepLayer(Editor &editor, bool up)
{
    std::vector<GroupId> layers = layersOf(*editor.document().painting());
    layers.insert(layers.begin(), 0);
    const auto at = std::ranges::find(layers, editor.layer().group());
    if (at == layers.end()) // It is one that is still to come.
        editor.layer().choose(0);
    else if (up && at != layers.begin())
        editor.layer().choose(*std::prev(at));
    else if (!up && std::next(at) != layers.end())
        editor.layer().choose(*std::next(at));
}

bool isOnlySolo(Editor &editor)
{
    const std::vector<Group> &groups = editor.unsettled().painting()->groups;
    const Group *layer = layerOf(editor);
    return layer && layer->solo && std::ranges::count_if(groups, &Group::solo) == 1;
}

} // namespace

void addLayerRows(Commands &table, OpenPainting &open)
{
    using enum Command;
    Editor &editor = open.editor;
    const auto isThere = [&editor] { return layerOf(editor) != nullptr; };
    const QString noLayer = Commands::tr("No layer is chosen: click one in the Strokes dock, or begin one with New Layer.");
    const auto says = [&table](const QString &text) {
        if (!text.isEmpty())
            emit table.said(text, saidMs);
    };
    const auto key = [](const QString &keys) { return QList<QKeySequence>{QKeySequence(keys)}; };
    const auto page = [](Qt::KeyboardModifiers modifiers, Qt::Key which) {
        return QList<QKeySequence>{QKeySequence(QKeyCombination(modifiers, which))};
    };
    table
        .add(NewLayer, "newLayer", Commands::tr("&New Layer"), "", key(Commands::tr("Ctrl+Shift+N")),
             Commands::tr("Paint on a new layer above this one; it comes with its first stroke"))
        .runs([&editor] { editor.layer().beginNew(); });
    table
        .add(NewClippedLayer, "newClippedLayer", Commands::tr("New &Clipped Layer"), "",
             key(Commands::tr("Ctrl+Alt+N")),
             Commands::tr("Paint on a new layer that shows only where the layer below has paint: a clipping mask"))
        .when([&editor] { return editor.layer().group() != 0; }, noLayer)
        .runs([&editor] { editor.layer().beginClipped(); });
    table.add(DuplicateLayer, "duplicateLayer", Commands::tr("&Duplicate Layer"), "", key(Commands::tr("Ctrl+J")))
        .when(isThere, noLayer)
        .runs([&editor] { duplicateLayer(editor); });
    table
        .add(MergeLayerDown, "mergeLayerDown", Commands::tr("&Merge Down"), "", key(Commands::tr("Ctrl+M")),
             Commands::tr("Put the layer onto the one just below it; the picture stays"))
        .when(isThere, noLayer)
        .runs([&editor, says] { says(mergeLayerDown(editor)); });
    table
        .add(RaiseLayer, "raiseLayer", Commands::tr("&Raise Layer"), "",
             page(Qt::ControlModifier | Qt::ShiftModifier, Qt::Key_PageUp))
        .when(isThere, noLayer)
        .runs([&editor, says] { says(moveLayer(editor, true)); });
    table
        .add(LowerLayer, "lowerLayer", Commands::tr("&Lower Layer"), "",
             page(Qt::ControlModifier | Qt::ShiftModifier, Qt::Key_PageDown))
        .when(isThere, noLayer)
        .runs([&editor, says] { says(moveLayer(editor, false)); });
    const auto anyLayers = [&editor] { return !editor.unsettled().painting()->groups.empty(); };
    table
        .add(LayerAbove, "layerAbove", Commands::tr("Layer &Above"), "", page(Qt::ControlModifier, Qt::Key_PageUp),
             Commands::tr("Paint on the next layer above; above all of them there is none"))
        .when(anyLayers, Commands::tr("The painting has no layers yet: New Layer begins one."))
        .runs([&editor] { stepLayer(editor, true); });
    table
        .add(LayerBelow, "layerBelow", Commands::tr("Layer &Below"), "", page(Qt::ControlModifier, Qt::Key_PageDown),
             Commands::tr("Paint on the next layer below"))
        .when(anyLayers, Commands::tr("The painting has no layers yet: New Layer begins one."))
        .runs([&editor] { stepLayer(editor, false); });
    table.add(NoLayer, "noLayer", Commands::tr("N&o Layer"), "", {}, Commands::tr("Paint on top of all again"))
        .when([&editor] { return editor.layer().group() != 0; }, noLayer)
        .runs([&editor] { editor.layer().choose(0); });
    table
        .add(HideOtherLayers, "hideOtherLayers", Commands::tr("&Hide Others"), "", key(Commands::tr("Ctrl+Shift+H")),
             Commands::tr("Show only this layer, or all again"))
        .when(isThere, noLayer)
        .checkedWhen([&editor] { return isOnlySolo(editor); })
        .runs([&editor, says] {
            const bool shows = isOnlySolo(editor);
            editor.push(toggleSolo(editor.document(), editor.layer().group()),
                        shows ? Commands::tr("Show other layers") : Commands::tr("Hide other layers"));
            commands::deselectHidden(editor);
            if (const Group *layer = layerOf(editor); layer && layer->clips && !shows)
                says(Commands::tr("It is clipped to a layer that is hidden now, so nothing of it is seen."));
        });
    table
        .add(ThisLayerOnly, "thisLayerOnly", Commands::tr("&This Layer Only"), "layer-only", {},
             Commands::tr("Tools reach only what is on the layer, where there is one"))
        .checkable()
        .checkedWhen([&editor] { return editor.layer().isOnly(); })
        .toggles([&editor](bool on) { editor.layer().setOnly(on); });
    QObject::connect(&editor.layer(), &CurrentLayer::changed, &table, [&table] { table.update(); });
}

} // namespace suffuse
