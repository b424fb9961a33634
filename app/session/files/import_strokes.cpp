#include "app/session/files/import_strokes.h"

#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "model/formats/messages.h"
#include "model/formats/picture_links.h"
#include "model/painting/resolution.h"
#include "model/painting/validate.h"
#include "model/shaping/transform.h"
#include "undo/edits.h"
#include "undo/text_links.h"

#include <QFileInfo>

#include <algorithm>
#include <map>
#include <span>
#include <utility>

namespace suffuse {

namespace {

Rect controlBoxOf(const std::vector<Stroke> &strokes)
{
    Rect box;
    for (const Stroke &stroke : strokes)
        box = box.united(controlBox(stroke));
    return box;
}

/// When the last of their segments and fills is born.
Microseconds latestBirthOf(const std::vector<Stroke> &strokes)
{
    Microseconds latest = 0;
    for (const Stroke &stroke : strokes) {
        for (const Segment &segment : stroke.segments)
            latest = std::max(latest, segment.born);
        if (stroke.fill)
            latest = std::max(latest, stroke.fill->born);
    }
    return latest;
}

/// Moves the strokes back in time, none of them to before 0.
void bringBack(std::vector<Stroke> &strokes, Microseconds by)
{
    for (Stroke &stroke : strokes) {
        for (Segment &segment : stroke.segments) {
            const Microseconds shift = std::clamp<Microseconds>(segment.born, 0, by); // before 0 they stay
            segment.born -= shift;
            for (Rewet &rewet : segment.rewet)
                rewet.time -= shift;
        }
        if (stroke.fill) {
            Fill fill = *stroke.fill;
            fill.born -= std::clamp<Microseconds>(fill.born, 0, by);
            stroke.fill = fill;
        }
    }
}

struct Placed {
    Point by;     ///< how far what comes is moved
    QString said; ///< where it lies, if not where it was expected
};

/// Of strokes with that box.
Placed placedBy(const Landing &landing, const Rect &box)
{
    Placed placed;
    if (landing.middle)
        placed.by = *landing.middle - box.centre();
    const Rect there{box.left + placed.by.x, box.top + placed.by.y, box.right + placed.by.x, box.bottom + placed.by.y};
    if (landing.seen.isEmpty() || box.isEmpty() || there.intersects(landing.seen))
        return placed;
    if (!landing.middle) {
        placed.said = QCoreApplication::translate("Clipboard", "What was pasted lies outside of what is seen of the "
                                                               "canvas. View ▸ Zoom to Selection goes there.");
        return placed;
    }
    placed.by = landing.seen.centre() - box.centre();
    placed.said = QCoreApplication::translate(
        "Clipboard", "There it would not be seen: what was pasted lies in the middle of what is seen of the canvas.");
    return placed;
}

/// Puts all strokes into one group of that name.
Painting inOneGroup(Painting painting, const QString &name)
{
    Group around;
    for (const Group &group : painting.groups)
        around.id = std::max(around.id, group.id);
    ++around.id;
    around.name = name;
    for (Group &group : painting.groups)
        group.parent = group.parent ? group.parent : around.id;
    painting.groups.push_back(around);
    StrokeList members;
    for (const StrokePtr &stroke : painting.strokes) {
        Stroke member = *stroke;
        member.group = member.group ? member.group : around.id;
        members.push_back(std::make_shared<const Stroke>(std::move(member)));
    }
    painting.strokes = std::move(members);
    return painting;
}

std::vector<Swatch> withSwatches(std::vector<Swatch> swatches, const std::vector<Swatch> &more)
{
    for (const Swatch &swatch : more)
        if (std::ranges::find(swatches, swatch) == swatches.end())
            swatches.push_back(swatch);
    return swatches;
}

bool isNameTaken(const std::vector<Group> &groups, const QString &name)
{
    return !name.isEmpty() && std::ranges::find(groups, name, &Group::name) != groups.end();
}

} // namespace

QString addStrokes(Editor &editor, const Painting &added, const Landing &landing, const QString &undoText,
                   const std::vector<Swatch> &paints)
{
    std::vector<Stroke> strokes;
    for (const StrokePtr &stroke : added.strokes)
        strokes.push_back(*stroke);
    for (Stroke &stroke : strokes)
        stroke.visible = true, stroke.locked = false;
    Document &document = editor.document();
    const Microseconds later = latestBirthOf(strokes) - editor.clock().time();
    const bool isFirst = document.painting()->strokes.empty(); // there is no time yet that they could disagree with
    const bool keepsTimes = isFirst || landing.goesOn;
    if (later > 0 && !keepsTimes)
        bringBack(strokes, later); // pasted paint is seen at once
    Edit edit;
    std::map<GroupId, GroupId> fresh;
    for (const Group &group : added.groups)
        fresh[group.id] = document.takeGroupId();
    const Placed placed = placedBy(landing, controlBoxOf(strokes));
    const Point by = placed.by;
    if (!added.groups.empty()) {
        edit.groups = document.painting()->groups;
        for (Group group : added.groups) {
            group.locked = group.solo = false; // What comes hides nothing that is there.
            group.id = fresh[group.id];
            group.parent = fresh.contains(group.parent) ? fresh[group.parent] : 0;
            group.text = moved(group.text, by);
            if (group.parent == 0 && isNameTaken(document.painting()->groups, group.name))
                group.name = nameOfCopy(*edit.groups, group.name);
            edit.groups->push_back(std::move(group));
        }
    }
    edit.order.emplace();
    for (const StrokePtr &stroke : document.painting()->strokes)
        edit.order->push_back(stroke->id);
    edit.selection.emplace();
    std::vector<Group> groups = edit.groups.value_or(std::vector<Group>());
    for (Group &group : groups)
        group.solo = false; // Where it hid what comes, it will not.
    const Visibility isSeen(groups);
    int refused = 0;
    std::unordered_map<StrokeId, StrokeId> ids;
    for (Stroke &stroke : strokes) {
        const StrokeId original = std::exchange(stroke.id, document.takeStrokeId());
        stroke.group = fresh.contains(stroke.group) ? fresh[stroke.group] : 0;
        stroke.origin = stroke.origin + by;
        if (!problemOf(stroke).isEmpty()) {
            ++refused;
            continue;
        }
        ids.emplace(original, stroke.id);
        edit.order->push_back(stroke.id);
        if (landing.selects && isSeen(stroke))
            edit.selection->strokes.insert(stroke.id);
        edit.strokes.emplace(stroke.id, std::make_shared<const Stroke>(std::move(stroke)));
    }
    if (edit.groups)
        linkCopies(std::span(*edit.groups).subspan(document.painting()->groups.size()), ids, by);
    const bool comes = !edit.strokes.empty();
    if (comes) {
        if (!paints.empty())
            edit.swatches = withSwatches(document.painting()->swatches, paints);
        const std::vector<GroupId> layers = layersAdded(*document.painting(), edit);
        editor.push(editor.layer().takePasted(std::move(edit)), undoText);
        if (layers.size() == 1 && editor.layer().group() != 0)
            editor.layer().chooseByStep(layers.front());
    }
    if (comes && later > 0 && keepsTimes)
        editor.clock().setTime(document.painting()->end()); // as its file is seen when it is opened
    return joinedSentences(
        {comes ? placed.said : QString(),
         refused == 0 ? QString()
                      : QCoreApplication::translate("Clipboard",
                                                    "%Ln stroke(s) cannot lie there, too far out, and were left out.",
                                                    nullptr, refused),
         comes && later > 0 && !keepsTimes
             ? QCoreApplication::translate("Clipboard", "What came was painted after the moment that you look at. "
                                                        "It was brought back to this moment, so that you see it.")
             : QString()});
}

Painting atRealSize(Painting painting, double from, double to)
{
    if (!isResolution(from) || !isResolution(to) || from == to)
        return painting;
    const Affine map = Affine::scaling({}, to / from, to / from);
    StrokeList strokes;
    for (const StrokePtr &stroke : painting.strokes)
        strokes.push_back(std::make_shared<const Stroke>(transformed(*stroke, map, SpreadRule::Scales)));
    painting.strokes = std::move(strokes);
    for (Group &group : painting.groups)
        if (group.text) {
            Text text = *group.text;
            text.place = map * text.place;
            group.text = std::move(text);
        }
    return painting;
}

Result<ImportReport> importStrokes(Editor &editor, const QString &path, Point centre)
{
    const Result<LoadedDocument> file = loadDocument(path, &editor.brush());
    if (!file)
        return Error{file.error()};
    if (file->painting.strokes.empty() && file->losses.empty())
        return fileError(path, QCoreApplication::translate("Import", "there are no strokes in it"));
    const Painting painting = atRealSize(withAbsoluteLinks(file->painting, QFileInfo(path).absolutePath()),
                                         file->extras.resolution, std::as_const(editor).extras().resolution);
    const QString refused = addStrokes(editor, inOneGroup(painting, QFileInfo(path).completeBaseName()), centre,
                                       QCoreApplication::translate("Import", "Import strokes"));
    return ImportReport{file->losses, joinedSentences({refused, file->leftOut, file->missing})};
}

} // namespace suffuse
