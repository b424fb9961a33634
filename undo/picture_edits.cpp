#include "undo/picture_edits.h"

#include "model/painting/validate.h"
#include "model/shaping/picture_stroke.h"

namespace suffuse {

Edit changePictures(const Document &document, const std::set<StrokeId> &strokes,
                    const std::function<void(Picture &)> &change)
{
    Edit edit;
    for (const StrokeId id : strokes) {
        const StrokePtr stroke = document.painting()->find(id);
        if (!stroke || !stroke->picture || document.painting()->isLocked(*stroke))
            continue;
        Picture picture = *stroke->picture;
        change(picture);
        if (picture == *stroke->picture && picture.image == stroke->picture->image)
            continue;
        Stroke changed = *stroke;
        changed.picture = std::move(picture);
        if (problemOf(changed).isEmpty())
            edit.strokes.emplace(id, std::make_shared<const Stroke>(std::move(changed)));
    }
    return edit;
}

Edit underlayToLayer(Document &document, const Picture &picture, const QString &name, Microseconds seen)
{
    const Painting &painting = *document.painting();
    Edit edit;
    if (!painting.underlay)
        return edit;
    Group group;
    group.id = document.takeGroupId();
    group.name = name;
    group.isolated = true;
    group.opacity = painting.underlay->opacity;
    group.visible = painting.underlay->visible;
    Stroke stroke = pictureStroke(picture, painting.underlay->area, seen);
    stroke.id = document.takeStrokeId();
    stroke.group = group.id;
    if (!problemOf(stroke).isEmpty())
        return edit;
    edit.order.emplace({stroke.id});
    for (const StrokePtr &other : painting.strokes)
        edit.order->push_back(other->id);
    edit.groups = painting.groups;
    edit.groups->push_back(std::move(group));
    edit.underlay.emplace(nullptr);
    edit.selection.emplace().strokes.insert(stroke.id);
    edit.strokes.emplace(stroke.id, std::make_shared<const Stroke>(std::move(stroke)));
    return edit;
}

} // namespace suffuse
