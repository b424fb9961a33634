// The ICC profile of sRGB (IEC 61966-2-1) in TIFF and JPEG files, made by lcms2.
#include "render/image_io/module/formats.h"

#include <lcms2.h>

#include <memory>

namespace suffuse {

namespace {

std::string makeProfile()
{
    const std::unique_ptr<void, cmsBool (*)(cmsHPROFILE)> profile(cmsCreate_sRGBProfile(), cmsCloseProfile);
    cmsUInt32Number size = 0;
    std::string bytes;
    if (profile && cmsSaveProfileToMem(profile.get(), nullptr, &size))
        bytes.resize(size);
    if (bytes.empty() || !cmsSaveProfileToMem(profile.get(), bytes.data(), &size))
        throw std::bad_alloc();
    // lcms2 dates a profile by the clock, while equal pictures must give equal files. So the date is set to midnight of
    // 2024-01-01.
    constexpr std::size_t creationDate = 24;
    constexpr char date[] = {2024 / 256, char(2024 % 256), 0, 1, 0, 1, 0, 0, 0, 0, 0, 0};
    return bytes.replace(creationDate, sizeof date, date, sizeof date);
}

} // namespace

const std::string &srgbProfile()
{
    static const std::string profile = makeProfile();
    return profile;
}

} // namespace suffuse

extern "C" __attribute__((visibility("default"))) const char *suffuse_image_profile(std::size_t *size)
{
    try {
        *size = suffuse::srgbProfile().size();
        return suffuse::srgbProfile().data();
    } catch (const std::bad_alloc &) {
        return nullptr;
    }
}
