#include "render/renderer.h"

namespace suffuse {

QString nameOf(Backend backend)
{
    switch (backend) {
    case Backend::Auto:
        return QStringLiteral("auto");
    case Backend::Cpu:
        return QStringLiteral("CPU");
    case Backend::Cuda:
        return QStringLiteral("CUDA");
    case Backend::Reference:
        return QStringLiteral("reference");
    }
    return {};
}

} // namespace suffuse
