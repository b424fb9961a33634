#include "render/drawing/pdf_page.h"

#include "model/painting/ryb.h"
#include "render/drawing/pdf_image.h"

#include <QCoreApplication>

namespace suffuse {

namespace {

/// Pages may have so many units; those of larger ones are larger.
constexpr double mostPageUnits = 14'400;

/// What the picture leaves free at each side of the sheet, of its width and height.
constexpr double imageInset = 1e-6;

/// In the order of BlendMode.
constexpr const char *pdfModes[] = {"Normal",     "Multiply",   "Screen",    "Overlay",   "Darken",     "Lighten",
                                    "ColorDodge", "ColorBurn",  "HardLight", "SoftLight", "Difference", "Exclusion",
                                    "Hue",        "Saturation", "Color",     "Luminosity"};

} // namespace

PdfPageWriter::PdfPageWriter(const PdfPage &page, pdf::Objects &objects, const std::atomic<bool> *cancel)
    : m_page(page), m_painting(*page.drawing.painting), m_objects(objects), m_cancel(cancel), m_resources(objects),
      m_strokes(page.drawing, objects, m_resources, cancel)
{}

Result<int> PdfPageWriter::write(const QByteArray &rgb)
{
    const Rect sheet = m_painting.canvas.area();
    const PageSize own = ownPage(sheet.width(), sheet.height());
    const PageSize paper = m_page.paper ? m_page.paper->laidAs(sheet.width(), sheet.height()) : own;
    const double unit = std::max(1.0, std::max(paper.width, paper.height) / mostPageUnits);
    const double width = paper.width / unit, height = paper.height / unit;
    const double scale = std::min(width / sheet.width(), height / sheet.height());
    const Affine map{scale, 0, 0, -scale, {(width - scale * sheet.width()) / 2, (height + scale * sheet.height()) / 2}};
    m_content.push_back("q\n" + pdfMatrix(map) + " cm\n" + pdfBox(sheet) + " re W n\n");
    if (const Result<void> written = writeContent(); !written)
        return Error{written.error()};
    content() += "Q\n";
    if (!rgb.isEmpty())
        m_resources.setSpace("/DefaultRGB", rgb);
    m_resources.complete();
    const int stream = m_objects.addStream("<< >>", content());
    return m_objects.add("<< /Type /Page /Parent " + pdf::reference(pdf::Objects::pages) + " /MediaBox [0 0 " +
                         pdf::number(width) + ' ' + pdf::number(height) + ']' +
                         (unit > 1 ? " /UserUnit " + pdf::number(unit) : QByteArray()) + " /Contents " +
                         pdf::reference(stream) + " /Resources " + pdf::reference(m_resources.number()) +
                         " /Group << /S /Transparency /I true /CS /DeviceRGB >> >>");
}

Result<void> PdfPageWriter::writeContent()
{
    if (const Result<void> below = writeBelow(); !below)
        return below;
    if (m_page.drawing.unpainted) {
        m_outlines = addLayer(QCoreApplication::translate("Drawing", "Outlines"));
        m_hidden.push_back(m_outlines);
        content() += "/OC " + m_resources.layer(m_outlines) + " BDC\n";
    }
    const bool bounded = m_page.drawing.bounds.contains(0);
    if (bounded)
        m_content.emplace_back();
    for (const DrawnStroke &stroke : m_page.drawing.strokes) {
        if (m_cancel && m_cancel->load(std::memory_order_relaxed))
            return Error{};
        goTo(stroke.stroke->group);
        content() += m_strokes.of(stroke);
    }
    goTo(0);
    if (bounded) {
        const QByteArray inside = std::move(m_content.back());
        m_content.pop_back();
        content() += together(inside, {}, 0);
    }
    if (m_outlines != 0)
        content() += "EMC\n";
    return {};
}

/// The picture, or the canvas' colour.
Result<void> PdfPageWriter::writeBelow()
{
    const Canvas &canvas = m_painting.canvas;
    if (!m_page.png.isEmpty()) {
        const Result<int> image = addImage(m_objects, {m_page.png});
        if (!image)
            return Error{image.error()};
        // poppler, and what it draws for, widens an image that ends where a pixel does by one more pixel.
        const Rect box = Rect::of(imageInset * canvas.width, imageInset * canvas.height,
                                  (1 - 2 * imageInset) * canvas.width, (1 - 2 * imageInset) * canvas.height);
        const Affine map{box.width(), 0, 0, -box.height(), {box.left, box.bottom}};
        content() += "q\n" + pdfMatrix(map) + " cm\n" + m_resources.painted(*image) + " Do\nQ\n";
    } else if (canvas.background.opacity > 0) {
        const std::array<double, 3> rgb = srgbFromRyb(canvas.background);
        const double opacity = double(canvas.background.opacity);
        content() += "q\n" + (opacity < 1 ? m_resources.state("/ca " + pdf::number(opacity)) + " gs\n" : QByteArray()) +
                     pdfColour({rgb[0], rgb[1], rgb[2], 1}) + " rg\n" + pdfBox(canvas.area()) + " re f\nQ\n";
    }
    return {};
}

void PdfPageWriter::goTo(GroupId id)
{
    std::vector<const Group *> wanted;
    for (const Group *group = m_painting.findGroup(id); group; group = m_painting.findGroup(group->parent))
        wanted.insert(wanted.begin(), group);
    std::size_t same = 0;
    while (same < m_open.size() && same < wanted.size() && m_open[same] == wanted[same])
        ++same;
    while (m_open.size() > same)
        end();
    for (; same < wanted.size(); ++same)
        begin(*wanted[same]);
}

void PdfPageWriter::begin(const Group &group)
{
    m_open.push_back(&group);
    content() += layerOf(group);
    if (comesTogether(m_page.drawing, group) && !m_page.drawing.unpainted)
        m_content.emplace_back();
}

void PdfPageWriter::end()
{
    const Group &group = *m_open.back();
    m_open.pop_back();
    if (comesTogether(m_page.drawing, group) && !m_page.drawing.unpainted) {
        const QByteArray inside = std::move(m_content.back());
        m_content.pop_back();
        QByteArray state;
        if (group.opacity < 1)
            state += "/ca " + pdf::number(double(group.opacity)) + ' ';
        if (group.blend != BlendMode::Normal && group.blend < BlendMode::Plus)
            state += QByteArray("/BM /") + pdfModes[int(group.blend)] + ' ';
        content() += together(inside, state, group.id);
    }
    if (m_groups.contains(group.id))
        content() += "EMC\n";
}

/// What paints content as one, seen through what bounds the group.
QByteArray PdfPageWriter::together(const QByteArray &inside, QByteArray state, GroupId group)
{
    const Rect sheet = m_painting.canvas.area();
    const QByteArray box = "0 0 " + pdf::number(sheet.width()) + ' ' + pdf::number(sheet.height());
    if (const auto bounds = m_page.drawing.bounds.find(group); bounds != m_page.drawing.bounds.end()) {
        QByteArray mask;
        for (const DrawnBound &bound : bounds->second) {
            QByteArray shape, through;
            for (const DrawnStroke &stroke : bound.strokes)
                shape += m_strokes.of(stroke);
            if (bound.opacity < 1)
                through += "/ca " + pdf::number(bound.opacity) + ' ';
            mask = painted(m_resources.addGroup(box, shape), through + mask);
            mask = "/SMask << /S /Alpha /G " + pdf::reference(m_resources.addGroup(box, mask)) + " >> ";
        }
        state += mask;
    }
    return painted(m_resources.addGroup(box, inside), state);
}

/// What paints a form in a state.
QByteArray PdfPageWriter::painted(int form, const QByteArray &state)
{
    return "q\n" + (state.isEmpty() ? QByteArray() : m_resources.state(state) + " gs\n") + m_resources.painted(form) +
           " Do\nQ\n";
}

/// The beginning of a group's layer, if it has a name.
QByteArray PdfPageWriter::layerOf(const Group &group)
{
    if (group.name.isEmpty())
        return {};
    const auto [known, isNew] = m_groups.try_emplace(group.id);
    if (isNew) {
        known->second = addLayer(group.name);
        m_met.push_back(group.id);
    }
    return "/OC " + m_resources.layer(known->second) + " BDC\n";
}

int PdfPageWriter::addLayer(const QString &name)
{
    m_layers.push_back(m_objects.add("<< /Type /OCG /Name " + pdf::text(name) + " >>"));
    return m_layers.back();
}

/// `parent`: 0 or a group with a name. What is in a group without one is listed where that group would be.
QByteArray PdfPageWriter::orderWithin(GroupId parent) const
{
    const auto namedAround = [&](GroupId id) {
        const Group *group = m_painting.findGroup(id);
        do
            group = group ? m_painting.findGroup(group->parent) : nullptr;
        while (group && !m_groups.contains(group->id));
        return group ? group->id : 0;
    };
    QByteArray order;
    for (auto at = m_met.rbegin(); at != m_met.rend(); ++at)
        if (namedAround(*at) == parent) {
            order += ' ' + pdf::reference(m_groups.at(*at));
            if (const QByteArray within = orderWithin(*at); !within.isEmpty())
                order += " [" + within + ']';
        }
    if (parent == 0 && m_outlines != 0)
        return ' ' + pdf::reference(m_outlines) + (order.isEmpty() ? order : " [" + order + ']');
    return order;
}

} // namespace suffuse
