#include "render/image_io/colour_conversion.h"

#include "render/image_io/image_module.h"

#include <QCoreApplication>
#include <QFile>

#include <array>

namespace suffuse {

Result<QString> nameOfProfile(const QByteArray &profile)
{
    const Result<ImageModule> &module = colourModule();
    if (!module)
        return Error{module.error()};
    std::array<wchar_t, 256> name{};
    if (module->coloursName(profile.constData(), std::size_t(profile.size()), name.data(), name.size()) ==
        ModuleNoSpace)
        return Error{QCoreApplication::translate("ColourProfile", "it is no ICC profile of RGB, grey or CMYK")};
    return QString::fromWCharArray(name.data()).simplified();
}

QString titleOfProfile(const QByteArray &profile, const QString &otherwise)
{
    const Result<QString> name = nameOfProfile(profile);
    return name && !name->isEmpty() ? *name : otherwise;
}

Result<QByteArray> readProfile(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly) || file.size() > largestProfile)
        return Error{QCoreApplication::translate("ColourProfile", "%1: cannot be read, or is too large").arg(path)};
    const QByteArray bytes = file.readAll();
    if (const Result<QString> known = nameOfProfile(bytes); !known)
        return Error{QStringLiteral("%1: %2").arg(path, known.error())};
    return bytes;
}

Result<ColourConversion> ColourConversion::between(const ColourProfiles &profiles)
{
    const Result<ImageModule> &module = colourModule();
    if (!module)
        return Error{module.error()};
    const auto pointer = [](const QByteArray &bytes) -> const void * {
        return bytes.isEmpty() ? nullptr : bytes.constData();
    };
    ImageModuleColours colours{};
    colours.from = pointer(profiles.from), colours.fromSize = std::size_t(profiles.from.size());
    colours.to = pointer(profiles.to), colours.toSize = std::size_t(profiles.to.size());
    colours.proof = pointer(profiles.proof), colours.proofSize = std::size_t(profiles.proof.size());
    colours.intent = int(profiles.intent);
    colours.blackPoints = profiles.blackPoints;
    colours.marksGamut = profiles.marksGamut;
    std::array<char, 512> error{};
    void *opened = module->coloursOpen(&colours, error.data(), error.size());
    if (!opened)
        return Error{QString::fromUtf8(error.data())};
    ColourConversion out;
    out.m_isGrey = colours.isGrey;
    std::shared_ptr<void> conversion(opened, module->coloursClose);
    if (!colours.isSame) {
        out.m_conversion = std::move(conversion);
        out.m_apply = module->coloursApply;
    }
    return out;
}

void ColourConversion::apply(float *rgba, std::size_t pixels) const
{
    if (m_conversion)
        m_apply(m_conversion.get(), rgba, pixels);
}

} // namespace suffuse
