// SVG: whole drawings, and path data alone.
#include "fuzzing.h"

#include "model/formats/svg_paths.h"

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
    const QByteArray bytes = bytesOf(data, size);
    if (bytes.startsWith('<')) {
        if (const Result<std::vector<SvgPath>> paths = readSvgPaths(bytes))
            for (const SvgPath &path : *paths)
                requireFinite(path.curves);
        return 0;
    }
    for (const std::vector<Cubic> &curves : parsePathData(QString::fromLatin1(bytes)))
        requireFinite(curves);
    return 0;
}
