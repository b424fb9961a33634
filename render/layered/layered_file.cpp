#include "render/layered/layered_file.h"

#include "render/layered/ora_file.h"
#include "render/layered/psd_file.h"

namespace suffuse {

LayeredFormat layeredFormatFor(const QString &path)
{
    if (path.endsWith(QLatin1String(".ora"), Qt::CaseInsensitive))
        return LayeredFormat::OpenRaster;
    return path.endsWith(QLatin1String(".psd"), Qt::CaseInsensitive) ? LayeredFormat::Photoshop : LayeredFormat::None;
}

Result<LayeredStats> writeLayered(const QString &path, const LayeredRequest &request, Renderer &renderer,
                                  Renderer &groups)
{
    return layeredFormatFor(path) == LayeredFormat::Photoshop ? writePsd(path, request, renderer, groups)
                                                              : writeOpenRaster(path, request, renderer, groups);
}

} // namespace suffuse
