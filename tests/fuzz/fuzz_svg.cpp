// SVG: whole drawings, as paths and as paintings, and path data alone.
#include "fuzzing.h"

#include "model/formats/svg/svg_painting.h"
#include "model/painting/validate.h"
#include "tests/model/box_letters.h"

#include <cmath>

using namespace suffuse;

namespace {

void requireFinite(const std::vector<Cubic> &curves)
{
    for (const Cubic &curve : curves)
        for (const Point point : curve.p)
            require(std::isfinite(point.x) && std::isfinite(point.y), "curves are finite");
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static BoxLetters letters; // texts, without fonts of the machine
    letters.faces.clear();
    const QByteArray bytes = bytesOf(data, size);
    if (bytes.startsWith('<')) {
        if (const Result<std::vector<SvgPath>> paths = readSvgPaths(bytes))
            for (const SvgPath &path : *paths)
                requireFinite(path.curves);
        if (const Result<Painting> painting = readSvg(bytes, QStringLiteral("a.svg"), builtinBrushes().front()))
            require(problemOf(*painting).isEmpty(), "a drawing becomes a valid painting");
        return 0;
    }
    for (const std::vector<Cubic> &curves : parsePathData(QString::fromLatin1(bytes)))
        requireFinite(curves);
    return 0;
}
