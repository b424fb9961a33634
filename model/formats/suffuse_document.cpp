#include "model/formats/embedded_image.h"
#include "model/formats/messages.h"
#include "model/formats/suffuse/suffuse_cbor.h"
#include "model/formats/suffuse/suffuse_strokes.h"

#include <algorithm>

namespace suffuse {

namespace {

QCborArray toCbor(const Colour &c)
{
    return {double(c.red), double(c.yellow), double(c.blue), double(c.opacity)};
}

/// Ids take all 64 bits; CBOR's signed integers of Qt carry them by their bits.
qint64 toCbor(std::uint64_t id)
{
    return qint64(id);
}

int placeOfImage(const EncodedImage &image, std::vector<EncodedImage> &images)
{
    const auto same = [&](const EncodedImage &other) { return other == image || *other == *image; };
    const auto place = std::find_if(images.begin(), images.end(), same) - images.begin();
    if (std::size_t(place) == images.size())
        images.push_back(image);
    return int(place);
}

QCborMap toCbor(const Canvas &canvas, std::vector<EncodedImage> &images)
{
    const Paper &p = canvas.paper;
    QCborMap paper{{QLatin1String("kind"), int(p.kind)},
                   {QLatin1String("seed"), qint64(p.seed)},
                   {QLatin1String("scale"), double(p.scale)},
                   {QLatin1String("strength"), double(p.strength)}};
    if (p.grain != PaperGrain::Tooth)
        paper.insert(QLatin1String("grain"), int(p.grain));
    if (p.image)
        paper.insert(QLatin1String("image"), placeOfImage(p.image, images));
    return {{QLatin1String("width"), canvas.width},
            {QLatin1String("height"), canvas.height},
            {QLatin1String("background"), toCbor(canvas.background)},
            {QLatin1String("paper"), paper}};
}

void readCanvas(const QCborValue &value, const std::vector<EncodedImage> &images, Canvas &canvas, bool &ok)
{
    MapReader in(value, ok);
    in.read("width", canvas.width);
    in.read("height", canvas.height);
    in.read("background", canvas.background);
    MapReader paper(in.take("paper"), ok);
    std::uint64_t kind = 0, grain = 0, seed = canvas.paper.seed;
    paper.read("kind", kind);
    paper.read("grain", grain);
    paper.read("seed", seed);
    paper.read("scale", canvas.paper.scale);
    paper.read("strength", canvas.paper.strength);
    paper.read("image", canvas.paper.image, images);
    ok = ok && kind <= std::uint64_t(PaperKind::Image) && grain <= std::uint64_t(PaperGrain::Weave) &&
         seed <= 0xffffffffu;
    canvas.paper.kind = PaperKind(kind);
    canvas.paper.grain = PaperGrain(grain);
    canvas.paper.seed = std::uint32_t(seed);
}

void readUnderlay(const QCborValue &value, const std::vector<EncodedImage> &images, Painting &painting, bool &ok)
{
    auto underlay = std::make_shared<Underlay>();
    MapReader in(value, ok);
    in.read("image", underlay->image, images);
    in.read("opacity", underlay->opacity);
    in.read("visible", underlay->visible);
    const QCborArray area = in.take("area").toArray();
    ok = ok && area.size() == 4;
    underlay->area = {area.at(0).toDouble(), area.at(1).toDouble(), area.at(2).toDouble(), area.at(3).toDouble()};
    painting.underlay = std::move(underlay);
}

} // namespace

QByteArray writeProperties(const Painting &painting, std::vector<EncodedImage> &images)
{
    QCborMap map{{QLatin1String("canvas"), toCbor(painting.canvas, images)}};
    QCborArray groups, swatches;
    for (const Group &g : painting.groups) {
        groups.append(QCborMap{{QLatin1String("id"), toCbor(g.id)},
                               {QLatin1String("name"), g.name},
                               {QLatin1String("parent"), toCbor(g.parent)},
                               {QLatin1String("visible"), g.visible},
                               {QLatin1String("locked"), g.locked}});
    }
    for (const Swatch &s : painting.swatches)
        swatches.append(QCborMap{{QLatin1String("name"), s.name}, {QLatin1String("colour"), toCbor(s.colour)}});
    if (!groups.isEmpty())
        map.insert(QLatin1String("groups"), groups);
    if (!swatches.isEmpty())
        map.insert(QLatin1String("swatches"), swatches);
    if (const auto &u = painting.underlay) {
        QCborMap underlay{{QLatin1String("area"), QCborArray{u->area.left, u->area.top, u->area.right, u->area.bottom}},
                          {QLatin1String("opacity"), double(u->opacity)},
                          {QLatin1String("visible"), u->visible}};
        if (u->image)
            underlay.insert(QLatin1String("image"), placeOfImage(u->image, images));
        map.insert(QLatin1String("underlay"), underlay);
    }
    return QCborValue(map).toCbor();
}

QString readProperties(QByteArrayView payload, const std::vector<EncodedImage> &images, Painting &painting)
{
    QCborParserError problem;
    const QCborValue value = QCborValue::fromCbor(payload.data(), payload.size(), &problem);
    if (problem.error != QCborError::NoError)
        return problem.errorString();
    bool ok = true;
    MapReader in(value, ok);
    readCanvas(in.take("canvas"), images, painting.canvas, ok);
    for (const QCborValue &item : in.take("groups").toArray()) {
        Group g;
        MapReader group(item, ok);
        group.read("id", g.id);
        group.read("name", g.name);
        group.read("parent", g.parent);
        group.read("visible", g.visible);
        group.read("locked", g.locked);
        painting.groups.push_back(g);
    }
    for (const QCborValue &item : in.take("swatches").toArray()) {
        Swatch s;
        MapReader swatch(item, ok);
        swatch.read("name", s.name);
        swatch.read("colour", s.colour);
        painting.swatches.push_back(s);
    }
    if (const QCborValue underlay = in.take("underlay"); !underlay.isUndefined())
        readUnderlay(underlay, images, painting, ok);
    return ok ? QString() : FileMessages::tr("a value has the wrong type");
}

} // namespace suffuse
