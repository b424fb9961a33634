#include "app/session/files/clipboard.h"

#include "app/session/colour_convert.h"
#include "app/session/editor.h"
#include "app/session/files/copied_pdf.h"
#include "app/session/files/image_layer.h"
#include "app/session/files/svg_strokes.h"
#include "model/formats/files.h"
#include "model/formats/messages.h"
#include "model/painting/editable.h"
#include "model/painting/influence.h"
#include "model/painting/resolution.h"
#include "model/shaping/erasing/erase.h"
#include "render/backends.h"
#include "undo/edits.h"

#include <QBuffer>
#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QImage>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace suffuse::clipboard {

namespace {

constexpr int longestSide = 4096;
constexpr char svgMime[] = "image/svg+xml";
constexpr char pngMime[] = "image/png";
constexpr char pdfMime[] = "application/pdf";
constexpr char imageMime[] = "application/x-qt-image";

/// What the paint reaches, in whole units.
Rect reachOf(const Painting &painting, Microseconds time)
{
    const Rect reach = influenceOf(painting, time);
    return reach.isEmpty()
               ? reach
               : Rect{std::floor(reach.left), std::floor(reach.top), std::ceil(reach.right), std::ceil(reach.bottom)};
}

QImage renderTransparent(const PaintingPtr &painting, Microseconds time)
{
    const Rect area = reachOf(*painting, time);
    if (area.isEmpty())
        return {};
    const double scale = std::min(1.0, longestSide / std::max(area.width(), area.height()));
    const int width = std::max(1, int(std::lround(area.width() * scale)));
    auto renderer = makeRenderer({.backend = Backend::Cpu});
    if (!renderer)
        return {};
    RenderRequest request;
    request.painting = painting;
    request.time = time;
    request.view = View::ofArea(area, width, std::max(1, heightForWidth(area, width)));
    request.transparent = true;
    Picture8 picture;
    if (!(*renderer)->render(request, picture))
        return {};
    return QImage(reinterpret_cast<const uchar *>(picture.argb.data()), picture.width, picture.height,
                  picture.width * 4, QImage::Format_ARGB32)
        .copy();
}

/// Holds the strokes as a value and makes the other forms on demand, so that copying costs nothing, whatever is
/// selected.
class StrokesMimeData : public QMimeData {
public:
    StrokesMimeData(Painting painting, Microseconds time)
        : m_painting(std::make_shared<const Painting>(std::move(painting))), m_time(time)
    {}

    QStringList formats() const override
    {
        return QMimeData::formats() + QStringList{strokesMime, svgMime, pdfMime, pngMime, imageMime};
    }
    bool hasFormat(const QString &type) const override { return formats().contains(type); }

protected:
    QVariant retrieveData(const QString &type, QMetaType wanted) const override
    {
        if (type == strokesMime)
            return writeTextForm(*m_painting);
        if (type == svgMime)
            return svgOf(*m_painting).bytes;
        if (type != pngMime && type != imageMime && type != pdfMime)
            return QMimeData::retrieveData(type, wanted);
        if (m_image.isNull())
            m_image = renderTransparent(m_painting, m_time);
        if (type == imageMime)
            return m_image;
        if (type == pdfMime)
            return pdfOfCopied(m_painting, m_time, reachOf(*m_painting, m_time), m_image);
        QByteArray bytes;
        QBuffer buffer(&bytes);
        m_image.save(&buffer, "PNG");
        return bytes;
    }

private:
    PaintingPtr m_painting;
    Microseconds m_time;
    mutable QImage m_image;
};

/// The stroke of a stroke's selected segments, each run of them a chain; or the stroke itself where no segments are
/// selected. None where the selected segments lay no paint.
std::optional<Stroke> selectedPart(const Stroke &stroke, const Selection &selection)
{
    const auto from = selection.segments.lower_bound({stroke.id, 0});
    if (from == selection.segments.end() || from->stroke != stroke.id)
        return stroke;
    std::vector<int> chosen;
    for (auto it = from; it != selection.segments.end() && it->stroke == stroke.id; ++it)
        chosen.push_back(it->segment);
    return withSegmentsOnly(stroke, chosen);
}

std::map<GroupId, GroupId> parentsOf(const Painting &painting)
{
    std::map<GroupId, GroupId> parents;
    for (const Group &group : painting.groups)
        parents[group.id] = group.parent;
    return parents;
}

/// The groups that come along: those that are copied as a whole. Strokes out of a group are strokes and no group.
/// `members` counts what is copied of each group by itself; in `incomplete` are those that keep strokes.
std::set<GroupId> groupsToCopy(const std::map<GroupId, GroupId> &parents, std::map<GroupId, int> members,
                               std::set<GroupId> incomplete)
{
    const auto depth = [&](GroupId group) {
        int levels = 0;
        for (; group; group = parents.at(group))
            ++levels;
        return levels;
    };
    std::vector<std::pair<int, GroupId>> innerFirst;
    for (const auto &[group, parent] : parents)
        innerFirst.emplace_back(-depth(group), group);
    std::ranges::sort(innerFirst);
    std::set<GroupId> result;
    for (const auto &[level, group] : innerFirst) {
        const GroupId parent = parents.at(group);
        const int copied = members[group];
        if (copied > 0)
            ++members[parent];
        if (incomplete.contains(group))
            incomplete.insert(parent);
        if (copied > 0 && !incomplete.contains(group))
            result.insert(group);
    }
    return result;
}

QByteArray svgFrom(const QMimeData &data)
{
    if (data.hasFormat(svgMime))
        return data.data(svgMime);
    const QString text = data.hasText() ? data.text().trimmed() : QString();
    static const QRegularExpression root("<([a-z]+:)?svg\\b"),
        shape("<(path|rect|circle|ellipse|line|polyline|polygon|g)\\b[^<]*>");
    if (!text.startsWith('<'))
        return {};
    if (text.contains(root))
        return text.toUtf8();
    // Single elements, as people copy them out of a document, need a drawing around them.
    return text.contains(shape) ? "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                                  "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
                                  "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
                                  "xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\">" +
                                      text.toUtf8() + "</svg>"
                                : QByteArray();
}

std::optional<Colour> colourFrom(const QMimeData &data)
{
    if (const auto colour = colourOf(data))
        return colour;
    const QString text = data.hasText() ? data.text().trimmed() : QString();
    if (text.startsWith('#') && QColor::isValidColor(text))
        return fromScreen(QColor(text));
    return {};
}

} // namespace

Painting asPainting(const Painting &painting, const Selection &selection)
{
    Painting result;
    result.canvas = painting.canvas;
    result.canvas.paper.image = nullptr; // a copy holds strokes and no image
    if (result.canvas.paper.kind == PaperKind::Image)
        result.canvas.paper = {};
    std::map<GroupId, int> members; // of each group, how many of its strokes and groups are copied
    std::set<GroupId> incomplete;   // not all of their own strokes are that can be selected
    std::set<GroupId> lacking;      // nor those that cannot
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        if (!selection.strokes.contains(stroke->id)) {
            lacking.insert(stroke->group);
            if (isEditable(*stroke))
                incomplete.insert(stroke->group);
            continue;
        }
        std::optional<Stroke> part = selectedPart(*stroke, selection);
        if (!part)
            continue;
        result.strokes.push_back(std::make_shared<const Stroke>(std::move(*part)));
        ++members[stroke->group];
    }
    const std::map<GroupId, GroupId> parents = parentsOf(painting);
    const std::set<GroupId> kept = groupsToCopy(parents, members, incomplete);
    const auto nearestKept = [&](GroupId group) {
        while (group && !kept.contains(group))
            group = parents.at(group);
        return group;
    };
    for (Group group : painting.groups) {
        if (!kept.contains(group.id))
            continue;
        group.parent = nearestKept(group.parent);
        if (lacking.contains(group.id))
            group.text = {}; // Some of a text's letters are no text: it would have all of them when it is edited.
        result.groups.push_back(std::move(group));
    }
    StrokeList placed;
    for (const StrokePtr &stroke : result.strokes) {
        const GroupId group = nearestKept(stroke->group);
        if (group == stroke->group) {
            placed.push_back(stroke);
            continue;
        }
        Stroke plain = *stroke;
        plain.group = group;
        placed.push_back(std::make_shared<const Stroke>(std::move(plain)));
    }
    result.strokes = std::move(placed);
    forgetLostCurves(result);
    return result;
}

QMimeData *mimeOf(Painting painting, Microseconds time, double resolution)
{
    auto *data = new StrokesMimeData(std::move(painting), time);
    if (isResolution(resolution))
        data->setData(resolutionMime, QByteArray::number(resolution, 'g', 17));
    return data;
}

bool canPaste(const QMimeData *data)
{
    return data && (data->hasFormat(strokesMime) || data->hasFormat(svgMime) || data->hasColor() || data->hasText() ||
                    data->hasImage());
}

namespace {

QString erasuresAlone()
{
    return QCoreApplication::translate("Clipboard", "An erasure is not copied without the paint that it takes away. "
                                                    "Duplicate doubles it within its stroke, Delete removes it.");
}

} // namespace

QString copy(Editor &editor)
{
    return copy(editor, editor.document().selection());
}

QString copy(Editor &editor, const Selection &selection)
{
    Painting painting = asPainting(*editor.document().painting(), selection);
    if (painting.strokes.empty())
        return selection.isEmpty() ? QString() : erasuresAlone();
    const SvgStrokes losses = lossesOf(painting);
    QGuiApplication::clipboard()->setMimeData(
        mimeOf(std::move(painting), editor.clock().time(), std::as_const(editor).extras().resolution));
    return leftOutOf(losses);
}

QString cut(Editor &editor)
{
    const Document &document = editor.document();
    if (asPainting(*document.painting(), document.selection()).strokes.size() < document.selection().strokes.size())
        return erasuresAlone(); // What would be lost stays.
    const QString leftOut = copy(editor);
    editor.push(deleteSelection(editor.document(), Leaves::Chains), QCoreApplication::translate("Clipboard", "Cut"));
    return leftOut;
}

QString paste(Editor &editor, const QMimeData &data, const Landing &landing)
{
    const QString pasting = QCoreApplication::translate("Clipboard", "Paste");
    if (data.hasFormat(strokesMime)) {
        const Result<Painting> read =
            readTextForm(data.data(strokesMime), QCoreApplication::translate("Clipboard", "Clipboard"));
        if (!read)
            return read.error();
        const double from = data.data(resolutionMime).toDouble(), to = std::as_const(editor).extras().resolution;
        return addStrokes(editor, atRealSize(*read, from, to), landing, pasting);
    }
    if (const QByteArray svg = svgFrom(data); !svg.isEmpty()) {
        Result<SvgDrawing> drawing = readSvgDrawing(svg);
        if (!drawing)
            return drawing.error();
        drawing->area = Rect::of(0, 0, 1, 1); // pasting in place means: where the drawing's own coordinates say
        const Painting painting = paintingAlong(*drawing, editor.brush(), editor.clock().time());
        const QString problem =
            painting.strokes.empty()
                ? QCoreApplication::translate("Clipboard", "There are no paths in the SVG of the clipboard.")
                : addStrokes(editor, painting, landing, pasting);
        return joinedSentences({problem, leftOutOf(*drawing)});
    }
    if (data.hasImage())
        return image_layer::paste(editor, qvariant_cast<QImage>(data.imageData()), landing);
    if (const auto colour = colourFrom(data)) {
        editor.setColour(*colour);
        return {};
    }
    return QCoreApplication::translate("Clipboard",
                                       "The clipboard holds no strokes, no SVG paths, no picture and no colour.");
}

} // namespace suffuse::clipboard
