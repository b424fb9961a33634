#include "app/session/files/image_layer.h"

#include "app/session/editor.h"
#include "app/session/files/picture_file.h"
#include "model/shaping/picture_stroke.h"
#include "model/shaping/transform.h"
#include "render/scene/picture.h"
#include "undo/edits.h"
#include "undo/picture_edits.h"
#include "undo/underlay_edits.h"

#include <QBuffer>
#include <QCursor>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>

#include <set>

namespace suffuse::image_layer {

namespace {

struct ImageLayer {
    Q_DECLARE_TR_FUNCTIONS(ImageLayer)
};

/// The pixels of all images that the painting's pictures have.
std::uint64_t pixelsOf(const Painting &painting)
{
    std::set<QString> seen;
    std::uint64_t pixels = 0;
    for (const StrokePtr &stroke : painting.strokes)
        if (stroke->picture && seen.insert(stroke->picture->sha256).second)
            pixels += stroke->picture->pixels();
    return pixels;
}

/// Why the painting cannot take another picture; empty: it can.
QString refusalOf(const Painting &painting, const Picture &picture, const QString &name)
{
    if (pixelsOf(painting) + picture.pixels() <= mostPicturePixels)
        return {};
    return ImageLayer::tr(
               "%1: the pictures of a painting may have %2 million pixels together, and this one would be too "
               "many. Scale it down, or remove another one.")
        .arg(name)
        .arg(mostPicturePixels / 1'000'000);
}

/// A group with one stroke that shows the picture, around a point.
Painting layerOf(const Picture &picture, const QString &name, const Rect &canvas, Point middle, Microseconds time)
{
    const double width = picture.width, height = picture.height;
    const bool fits = width <= canvas.width() && height <= canvas.height();
    Rect area = fits ? Rect::of(0, 0, width, height) : fitted(width, height, canvas);
    area = Rect::of(middle.x - 0.5 * area.width(), middle.y - 0.5 * area.height(), area.width(), area.height());
    Group group;
    group.id = 1;
    group.name = name;
    group.isolated = true;
    Stroke stroke = pictureStroke(picture, area, time);
    stroke.id = 1;
    stroke.group = group.id;
    Painting layer;
    layer.groups = {group};
    layer.strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
    return layer;
}

QString add(Editor &editor, const Picture &picture, const QString &name, const Landing &landing, const QString &step)
{
    const Painting &painting = *editor.document().painting();
    if (const QString refusal = refusalOf(painting, picture, name); !refusal.isEmpty())
        return refusal;
    const Rect canvas = painting.canvas.area();
    return addStrokes(editor, layerOf(picture, name, canvas, canvas.centre(), editor.clock().time()), landing, step);
}

/// Whether a stroke is nothing but a frame for its picture, which can be scaled with it.
bool isFrame(const Stroke &stroke)
{
    return stroke.fill && std::ranges::all_of(stroke.segments, [](const Segment &s) { return !(s.density > 0); });
}

} // namespace

Result<Picture> pictureOf(const EncodedImage &image, const QString &name)
{
    Picture picture = embeddedPicture(image, 1, 1);
    QGuiApplication::setOverrideCursor(Qt::WaitCursor); // since decoding a large picture takes a moment
    const Result<PictureLevelsPtr> levels = pictureLevels(picture, name);
    QGuiApplication::restoreOverrideCursor();
    if (!levels)
        return Error{levels.error()};
    const PictureLevel size = (*levels)->level(0);
    return embeddedPicture(image, size.width, size.height);
}

QString importFile(Editor &editor, const QString &path)
{
    const Result<EncodedImage> image = readPictureFile(path);
    if (!image)
        return image.error();
    const Result<Picture> picture = pictureOf(*image, path);
    if (!picture)
        return picture.error();
    return add(editor, *picture, QFileInfo(path).completeBaseName(), {}, ImageLayer::tr("Import picture"));
}

QString paste(Editor &editor, const QImage &image, const Landing &landing)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    const QString name = ImageLayer::tr("Picture");
    if (!image.save(&buffer, "PNG"))
        return ImageLayer::tr("The picture of the clipboard cannot be read.");
    const Result<Picture> picture = pictureOf(std::make_shared<const QByteArray>(std::move(bytes)), name);
    if (!picture)
        return picture.error();
    return add(editor, *picture, name, landing, ImageLayer::tr("Paste picture"));
}

void takeUnderlay(Editor &editor)
{
    Document &document = editor.document();
    const std::shared_ptr<const Underlay> underlay = document.painting()->underlay;
    if (!underlay || !underlay->image)
        return;
    const Result<Picture> picture = pictureOf(underlay->image, ImageLayer::tr("Underlay"));
    if (!picture || underlay->area.isEmpty())
        return;
    editor.push(underlayToLayer(document, *picture, ImageLayer::tr("Underlay"), editor.clock().time()),
                ImageLayer::tr("Underlay to layer"));
}

std::vector<StrokePtr> selectedPictures(const Editor &editor)
{
    const Painting &painting = *editor.unsettled().painting();
    std::vector<StrokePtr> strokes;
    for (const StrokeId id : editor.unsettled().selection().strokes)
        if (StrokePtr stroke = painting.find(id); stroke && stroke->picture && !painting.isLocked(*stroke))
            strokes.push_back(std::move(stroke));
    return strokes;
}

QString link(Editor &editor, const QString &path)
{
    const Result<EncodedImage> image = readPictureFile(path);
    if (!image)
        return image.error();
    const Result<Picture> linked = pictureOf(*image, path);
    if (!linked)
        return linked.error();
    const Document &document = editor.document();
    if (const QString refusal = refusalOf(*document.painting(), *linked, path); !refusal.isEmpty())
        return refusal;
    editor.push(changePictures(document, document.selection().strokes,
                               [&](Picture &picture) {
                                   picture.image = linked->image, picture.sha256 = linked->sha256;
                                   picture.width = linked->width, picture.height = linked->height;
                                   picture.link = QFileInfo(path).absoluteFilePath();
                               }),
                ImageLayer::tr("Link picture"));
    return {};
}

void embed(Editor &editor)
{
    const Document &document = editor.document();
    editor.push(changePictures(document, document.selection().strokes,
                               [](Picture &picture) {
                                   if (picture.image)
                                       picture.link.clear();
                               }),
                ImageLayer::tr("Embed picture"));
}

void resetProportions(Editor &editor)
{
    editor.settle();
    Edit edit;
    for (const StrokePtr &stroke : selectedPictures(editor)) {
        const Picture even = inProportion(*stroke->picture);
        const std::optional<Affine> before = mapOf(*stroke->picture).inverse();
        if (even == *stroke->picture || !before)
            continue;
        Stroke changed = *stroke;
        if (isFrame(*stroke)) {
            const Affine map = mapOf(even) * *before; // of offsets from the origin
            const Point origin = stroke->origin;
            changed = transformed(*stroke, Affine::translation(origin) * map * Affine::translation(-1 * origin),
                                  SpreadRule::Stays);
        } else {
            changed.picture = even;
        }
        edit.strokes.emplace(stroke->id, std::make_shared<const Stroke>(std::move(changed)));
    }
    editor.push(std::move(edit), ImageLayer::tr("Reset proportions"));
}

} // namespace suffuse::image_layer
