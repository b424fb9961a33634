#include "app/session/settings/renderer_options.h"

#include "app/session/settings/settings.h"
#include "model/environment.h"

namespace suffuse::settings {

RendererOptions rendererOptions()
{
    RendererOptions options;
    options.threads = threads();
    const QByteArray wish = QByteArray::fromStdString(environment::value(environment::Variable::Backend)).toLower();
    options.backend = wish == "cuda"   ? Backend::Cuda
                      : wish == "cpu"  ? Backend::Cpu
                      : wish == "auto" ? Backend::Auto
                                       : backend();
    return options;
}

} // namespace suffuse::settings
