#include "model/formats/ora/composite_op.h"

#include "model/painting/fields.h"

namespace suffuse::ora {

namespace {

QString nameOf(BlendMode mode)
{
    switch (mode) {
    case BlendMode::Normal:
        return QStringLiteral("src-over");
    case BlendMode::DestinationIn:
        return QStringLiteral("dst-in");
    case BlendMode::DestinationOut:
        return QStringLiteral("dst-out");
    case BlendMode::SourceAtop:
        return QStringLiteral("src-atop");
    default: { // OpenRaster has the words of CSS, and so has the painting.
        const std::string_view word = WordsOf<BlendMode>::list[std::size_t(mode)];
        return QString::fromLatin1(word.data(), qsizetype(word.size()));
    }
    }
}

} // namespace

QString compositeOp(BlendMode mode)
{
    return QStringLiteral("svg:") + nameOf(mode == BlendMode::Exclusion ? BlendMode::Normal : mode);
}

std::optional<BlendMode> blendModeFrom(const QString &compositeOp)
{
    // Krita writes modes that OpenRaster lacks with its own prefix.
    const QString name = compositeOp.mid(compositeOp.indexOf(QLatin1Char(':')) + 1);
    for (int mode = 0; mode < blendModes; ++mode)
        if (name == nameOf(BlendMode(mode)))
            return BlendMode(mode);
    return {};
}

} // namespace suffuse::ora
