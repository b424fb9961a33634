// Rows that work on whole strokes, and the one of the underlay.
#include "app/session/commands/session_rows.h"

#include "app/session/commands/selection_commands.h"
#include "app/session/commands/underlay_commands.h"
#include "app/session/files/image_layer.h"
#include "app/session/settings/settings.h"
#include "model/painting/stroke_values.h"
#include "undo/fill_edits.h"
#include "undo/text_edits.h"
#include "undo/text_links.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>

namespace suffuse {

namespace {

SpreadRule spreadRule(const Commands &table)
{
    return table[Command::ScaleSpread].isChecked() ? SpreadRule::Scales : SpreadRule::Stays;
}

/// The shortcut in this language.
QList<QKeySequence> key(const QString &keys)
{
    return {QKeySequence(keys)};
}

void addOrderRows(Commands &table, Editor &editor)
{
    using enum Command;
    const auto selected = anySelected(editor);
    const auto arranges = [&table, &editor](Arrange how) {
        return [&table, &editor, how] { emit table.said(commands::arrangeSelected(editor, how), 5000); };
    };
    table.add(Raise, "raise", Commands::tr("&Raise"), "raise", {QKeySequence(Qt::Key_PageUp)})
        .when(selected)
        .runs(arranges(Arrange::Raise));
    table.add(Lower, "lower", Commands::tr("&Lower"), "lower", {QKeySequence(Qt::Key_PageDown)})
        .when(selected)
        .runs(arranges(Arrange::Lower));
    table.add(Top, "top", Commands::tr("Raise to &Top"), "top", {QKeySequence(Qt::Key_Home)})
        .when(selected)
        .runs(arranges(Arrange::Top));
    table.add(Bottom, "bottom", Commands::tr("Lower to &Bottom"), "bottom", {QKeySequence(Qt::Key_End)})
        .when(selected)
        .runs(arranges(Arrange::Bottom));
}

void addSelectingRows(Commands &table, Editor &editor)
{
    using enum Command;
    const auto selected = anySelected(editor);
    table
        .add(InvertSelection, "invertSelection", Commands::tr("In&vert Selection"), "",
             {QKeySequence(Commands::tr("Ctrl+Shift+I")), QKeySequence(Commands::tr("!"))})
        .when(anyStrokes(editor))
        .runs([&editor] { commands::invertSelection(editor); });
    table
        .add(SameColour, "sameColour", Commands::tr("&Colour"), "", {},
             Commands::tr("Select all strokes of the same colour"))
        .when(selected)
        .runs([&editor] { commands::selectSameAs(editor, Same::Colour); });
    table
        .add(SameStyle, "sameStyle", Commands::tr("&Style"), "", {},
             Commands::tr("Select all strokes of the same style"))
        .when(selected)
        .runs([&editor] { commands::selectSameAs(editor, Same::Style); });
    table
        .add(SameBrush, "sameBrush", Commands::tr("&Brush"), "", {},
             Commands::tr("Select all strokes of the same brush"))
        .when(selected)
        .runs([&editor] { commands::selectSameAs(editor, Same::Brush); });
    table.add(SameName, "sameName", Commands::tr("&Name"), "", {}, Commands::tr("Select all strokes of the same name"))
        .when(selected)
        .runs([&editor] { commands::selectSameAs(editor, Same::Name); });
    table
        .add(Lasso, "lasso", Commands::tr("&Lasso"), "lasso", key(Commands::tr("L")),
             Commands::tr("Select what is drawn around; with Shift from paint, too"))
        .switches();
    table
        .add(TouchPath, "touchPath", Commands::tr("&Touch"), "touch-path", {},
             Commands::tr("Select what a path touches"))
        .switches();
    table.makeExclusive({Lasso, TouchPath}, QActionGroup::ExclusionPolicy::ExclusiveOptional);
}

/// What the groups that are selected as a whole are and can be, found once for all rows that ask while nothing changes.
class SelectedRoles {
public:
    explicit SelectedRoles(const Editor &editor) : m_editor(editor) {}

    const GroupRoles::State &operator()(GroupRole role)
    {
        const Document &document = m_editor.unsettled();
        if (m_painting != document.painting() || !(m_selection == document.selection())) {
            m_painting = document.painting();
            m_selection = document.selection();
            find(selectedGroups(document));
        }
        return m_states[std::size_t(role)];
    }

private:
    void find(const std::vector<GroupId> &groups)
    {
        m_states = {};
        if (groups.empty())
            return;
        const GroupRoles roles(*m_painting);
        for (const GroupRole role : groupRoles)
            m_states[std::size_t(role)] = roles.of(groups, role);
    }

    const Editor &m_editor;
    PaintingPtr m_painting;
    Selection m_selection;
    std::array<GroupRoles::State, groupRoles.size()> m_states;
};

void addRoleRows(Commands &table, Editor &editor)
{
    using enum Command;
    const auto roles = std::make_shared<SelectedRoles>(editor);
    const auto add = [&](GroupRole role, CommandRow &row) {
        row.when([roles, role] { return !(*roles)(role).possible.empty(); },
                 Commands::tr("Select a group that this can be."))
            .checkedWhen([roles, role] { return (*roles)(role).all(); })
            .runs([&editor, role] { commands::toggleSelectedRole(editor, role); });
    };
    add(GroupRole::Clipped,
        table.add(ClipGroups, "clipGroups", Commands::tr("Clip to Below"), "", key(Commands::tr("Ctrl+Alt+G")),
                  Commands::tr("The selected groups are seen only where the next thing below them in the same group "
                               "is; needs something below")));
    add(GroupRole::Mask, table.add(MaskGroups, "maskGroups", Commands::tr("Use as Mask"), "", {},
                                   Commands::tr("What is beside the selected groups is seen only where they have "
                                                "paint; needs something beside")));
    add(GroupRole::Wash, table.add(WashGroups, "washGroups", Commands::tr("Wash"), "", {},
                                   Commands::tr("The strokes of the selected groups are one, laid wet into wet")));
    add(GroupRole::Draft,
        table.add(DraftGroups, "draftGroups", Commands::tr("Draft"), "", {},
                  Commands::tr("The selected groups are seen here, and left out of what is exported")));
}

/// How many groups do something as a whole.
std::ptrdiff_t actingGroups(const Painting &painting)
{
    return std::ranges::count_if(painting.groups, [](const Group &group) { return group.isIsolated() || group.wash; });
}

/// Whether strokes or groups of a painting are locked or hidden, at the cost of the strokes that changed since it was
/// asked last.
class ClosedStrokes {
public:
    bool anyLocked(const Painting &painting)
    {
        return anyStroke(painting, locked) || std::ranges::any_of(painting.groups, &Group::locked);
    }
    bool anyHidden(const Painting &painting)
    {
        return anyStroke(painting, hidden) ||
               std::ranges::any_of(painting.groups, [](const Group &group) { return !group.visible || group.solo; });
    }

private:
    static constexpr std::uint8_t locked = 1, hidden = 2;

    bool anyStroke(const Painting &painting, std::uint8_t how)
    {
        m_strokes.follow(painting.strokes, [](const Stroke &stroke) {
            return std::uint8_t((stroke.locked ? locked : 0) | (stroke.visible ? 0 : hidden));
        });
        return std::any_of(m_strokes.begin(), m_strokes.end(), [how](std::uint8_t is) { return (is & how) != 0; });
    }

    StrokeValues<std::uint8_t> m_strokes;
};

void addGroupRows(Commands &table, Editor &editor)
{
    using enum Command;
    const auto selected = anySelected(editor);
    table.add(GroupStrokes, "group", Commands::tr("&Group"), "group-strokes", key(Commands::tr("Ctrl+G")))
        .when(selected)
        .runs([&editor] { commands::groupSelected(editor); });
    table.add(UngroupStrokes, "ungroup", Commands::tr("&Ungroup"), "ungroup", key(Commands::tr("Ctrl+Shift+G")))
        .when([&editor] { return canUngroup(editor.unsettled()); }, Commands::tr("Select strokes of a group."))
        .runs([&table, &editor] {
            const auto before = actingGroups(*editor.unsettled().painting());
            commands::ungroupSelected(editor);
            if (actingGroups(*editor.unsettled().painting()) < before)
                emit table.said(Commands::tr("What the group did as a whole (opacity, mode, isolation, clip, mask, "
                                             "wash) is gone with it."),
                                5000);
        });
    addRoleRows(table, editor);
    table
        .add(TextToStrokes, "textToStrokes", Commands::tr("Text to Strokes"), "", {},
             Commands::tr("Make plain strokes of the letters of the selected texts; they cannot be typed in any more"))
        .when([&editor] { return canTurnTexts(editor.unsettled()); }, Commands::tr("Select a text."))
        .runs([&editor] { editor.push(textsToStrokes(editor.document()), Commands::tr("Text to strokes")); });
    table
        .add(ReleaseTexts, "releaseTexts", Commands::tr("Release Text from Stroke"), "", {},
             Commands::tr("Let the selected texts keep their curves, whatever becomes of the strokes that they follow"))
        .when([&editor] { return canReleaseTexts(editor.unsettled()); },
              Commands::tr("Select a text that follows a stroke."))
        .runs([&editor] { editor.push(releaseTexts(editor.document()), Commands::tr("Release text from stroke")); });
    table.add(LockStrokes, "lock", Commands::tr("Loc&k"), "lock", key(Commands::tr("Ctrl+2")))
        .when(selected)
        .runs([&editor] { commands::lockSelected(editor); });
    const auto closed = std::make_shared<ClosedStrokes>();
    table.add(UnlockAll, "unlockAll", Commands::tr("U&nlock All"), "unlock", key(Commands::tr("Ctrl+Alt+2")))
        .when([closed, &editor] { return closed->anyLocked(*editor.unsettled().painting()); },
              Commands::tr("Nothing is locked."))
        .runs([&editor] { commands::unlockAllStrokes(editor); });
    table.add(HideStrokes, "hide", Commands::tr("&Hide"), "eye-off", key(Commands::tr("Ctrl+3")))
        .when(selected)
        .runs([&editor] { commands::hideSelected(editor); });
    table.add(ShowAll, "showAll", Commands::tr("Sho&w All"), "eye", key(Commands::tr("Ctrl+Alt+3")))
        .when([closed, &editor] { return closed->anyHidden(*editor.unsettled().painting()); },
              Commands::tr("Nothing is hidden."))
        .runs([&editor] { commands::showAllStrokes(editor); });
}

bool anySelectedStroke(const Document &document, const std::function<bool(const Stroke &)> &predicate)
{
    const std::set<StrokeId> &selected = document.selection().strokes;
    return !selected.empty() && std::ranges::any_of(document.painting()->strokes, [&](const StrokePtr &stroke) {
        return selected.contains(stroke->id) && predicate(*stroke);
    });
}

bool hasChains(const Stroke &stroke)
{
    return std::any_of(stroke.segments.begin() + 1, stroke.segments.end(),
                       [](const Segment &segment) { return segment.start && !segment.takesPaint(); });
}

void addFillRows(Commands &table, Editor &editor)
{
    using enum Command;
    table
        .add(FillStrokes, "fill", Commands::tr("&Fill"), "", key(Commands::tr("Ctrl+Shift+F")),
             Commands::tr("Wet what the selected strokes enclose; the inspector has its values"))
        .when(
            [&editor] {
                return anySelectedStroke(editor.unsettled(), [](const Stroke &stroke) { return !stroke.fill; });
            },
            Commands::tr("Select strokes without a fill."))
        .runs([&editor] {
            editor.push(addFills(editor.document(), editor.document().selection().strokes), Commands::tr("Fill"));
        });
    table
        .add(RemoveFills, "removeFill", Commands::tr("Remove Fill"), "", {},
             Commands::tr("Leave of the selected strokes their outlines"))
        .when(
            [&editor] {
                return anySelectedStroke(editor.unsettled(), [](const Stroke &stroke) { return bool(stroke.fill); });
            },
            Commands::tr("Select a filled stroke."))
        .runs([&editor] {
            editor.push(removeFills(editor.document(), editor.document().selection().strokes),
                        Commands::tr("Remove fill"));
        });
    table
        .add(AddGradients, "addGradient", Commands::tr("Add Gradient"), "", {},
             Commands::tr("The colour of the selected fills fades from left to right; needs a fill of one colour"))
        .when(
            [&editor] {
                return anySelectedStroke(editor.unsettled(),
                                         [](const Stroke &stroke) { return stroke.fill && !stroke.fill->gradient; });
            },
            Commands::tr("Select a fill of one colour."))
        .runs([&editor] {
            editor.push(addGradients(editor.document(), editor.document().selection().strokes),
                        Commands::tr("Add gradient"));
        });
    table
        .add(RemoveGradients, "removeGradient", Commands::tr("Remove Gradient"), "", {},
             Commands::tr("The selected fills have their first colour everywhere; needs a fill with a gradient"))
        .when(
            [&editor] {
                return anySelectedStroke(editor.unsettled(),
                                         [](const Stroke &stroke) { return stroke.fill && stroke.fill->gradient; });
            },
            Commands::tr("Select a fill with a gradient."))
        .runs([&editor] {
            editor.push(removeGradients(editor.document(), editor.document().selection().strokes),
                        Commands::tr("Remove gradient"));
        });
}

void addChainRows(Commands &table, Editor &editor)
{
    using enum Command;
    table
        .add(CombineStrokes, "combine", Commands::tr("&Combine"), "", key(Commands::tr("Ctrl+Alt+K")),
             Commands::tr("Make one stroke of the selected ones, whose paint adds up"))
        .when([&editor] { return editor.unsettled().selection().strokes.size() > 1; },
              Commands::tr("Select two strokes or more."))
        .runs([&editor, &table] {
            if (const QString why = commands::combineSelected(editor); !why.isEmpty())
                emit table.said(why, 8000);
        });
    table
        .add(BreakApart, "breakApart", Commands::tr("Break Apart"), "", key(Commands::tr("Ctrl+Shift+K")),
             Commands::tr("Make strokes of the parts of the selected ones"))
        .when([&editor] { return anySelectedStroke(editor.unsettled(), hasChains); },
              Commands::tr("Select a stroke that was combined or cut into parts."))
        .runs([&editor, &table] { emit table.said(commands::breakSelectedApart(editor), 8000); });
    table
        .add(RemoveErasures, "removeErasures", Commands::tr("Remove Erasures"), "", {},
             Commands::tr("Bring back what was erased softly from the selected strokes, or by the selected segments"))
        .when([&editor] { return anySelectedStroke(editor.unsettled(), &Stroke::hasErasure); },
              Commands::tr("Select a stroke from which something was erased softly."))
        .runs([&editor] { commands::removeSelectedErasures(editor); });
}

void addShapeRows(Commands &table, Editor &editor)
{
    using enum Command;
    const auto selected = anySelected(editor);
    const auto flips = [&table, &editor](Axis axis) {
        return [&table, &editor, axis] {
            if (const QString done = commands::flipSelected(editor, axis, spreadRule(table)); !done.isEmpty())
                emit table.said(done, 5000);
        };
    };
    table.add(FlipAcross, "flipAcross", Commands::tr("Flip Hori&zontally"), "flip-across", key(Commands::tr("Shift+H")))
        .when(selected)
        .runs(flips(Axis::Horizontal));
    table.add(FlipDown, "flipDown", Commands::tr("Flip &Vertically"), "flip-down", key(Commands::tr("Shift+V")))
        .when(selected)
        .runs(flips(Axis::Vertical));
    table
        .add(QuarterLeft, "quarterLeft", Commands::tr("Rotate by &90° Left"), "quarter-left",
             key(Commands::tr("Ctrl+[")))
        .when(selected)
        .runs([&editor, &table] { commands::quarterTurnSelected(editor, -1, spreadRule(table)); });
    table
        .add(QuarterRight, "quarterRight", Commands::tr("Rotate by 90° R&ight"), "quarter-right",
             key(Commands::tr("Ctrl+]")))
        .when(selected)
        .runs([&editor, &table] { commands::quarterTurnSelected(editor, 1, spreadRule(table)); });
    table
        .add(ScaleSpread, "scaleSpread", Commands::tr("&Scale Spread with the Shape"), "scale-spread", {},
             Commands::tr("Spread and density follow the shape when it is scaled"))
        .checkable(settings::scalesSpread())
        .toggles([](bool on) { settings::setScalesSpread(on); });
}

} // namespace

void addObjectRows(Commands &table, OpenPainting &open)
{
    using enum Command;
    Editor &editor = open.editor;
    addOrderRows(table, editor);
    addSelectingRows(table, editor);
    addGroupRows(table, editor);
    addFillRows(table, editor);
    addChainRows(table, editor);
    addShapeRows(table, editor);
    table
        .add(ShowUnderlay, "showUnderlay", Commands::tr("Show the Underl&ay"), "",
             {QKeySequence(Commands::tr("Shift+U"))})
        .when([&editor] { return bool(editor.document().painting()->underlay); },
              Commands::tr("The painting has no underlay."))
        .checkedWhen([&editor] {
            const auto &underlay = editor.document().painting()->underlay;
            return underlay && underlay->visible;
        })
        .runs([&table, &editor] { underlay::show(editor, table[ShowUnderlay].isChecked()); });
    table
        .add(UnderlayToLayer, "underlayToLayer", Commands::tr("Underlay to Layer"), "", {},
             Commands::tr("Make an image layer below all of the underlay, where it lies; it is exported then"))
        .when([&editor] { return bool(editor.document().painting()->underlay); },
              Commands::tr("The painting has no underlay."))
        .runs([&editor] { image_layer::takeUnderlay(editor); });
}

} // namespace suffuse
