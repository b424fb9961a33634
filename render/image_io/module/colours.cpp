// Converts colours between ICC profiles, by lcms2.
#include "render/image_io/module/entry.h"

#include <lcms2.h>

#include <array>
#include <cmath>
#include <memory>
#include <type_traits>
#include <vector>

namespace suffuse {

namespace {

using Profile = std::unique_ptr<void, cmsBool (*)(cmsHPROFILE)>;

/// Four floats a pixel, of which the first three are colour, or the first one grey.
constexpr cmsUInt32Number colourPixels =
    FLOAT_SH(1) | COLORSPACE_SH(PT_RGB) | CHANNELS_SH(3) | EXTRA_SH(1) | BYTES_SH(4);
constexpr cmsUInt32Number greyPixels =
    FLOAT_SH(1) | COLORSPACE_SH(PT_GRAY) | CHANNELS_SH(1) | EXTRA_SH(3) | BYTES_SH(4);

/// The channels of a profile's colours as lcms2 takes them: floats, 0 to 1, or, of inks, 0 to 100.
struct Channels {
    cmsUInt32Number format = 0;
    int count = 0;
    float most = 1;

    explicit Channels(cmsHPROFILE profile) : format(cmsFormatterForColorspaceOfProfile(profile, 4, TRUE))
    {
        const cmsColorSpaceSignature space = cmsGetColorSpace(profile);
        if (space == cmsSigRgbData || space == cmsSigGrayData)
            count = space == cmsSigRgbData ? 3 : 1;
        else if (space == cmsSigCmykData)
            count = 4, most = 100;
    }
};

using Transform = std::unique_ptr<void, void (*)(cmsHTRANSFORM)>;

/// lcms2 in a context of its own, so that a broken profile of one thread says nothing on another.
class Conversion {
public:
    Conversion() : m_context(cmsCreateContext(nullptr, nullptr), cmsDeleteContext)
    {
        if (!m_context)
            throw std::bad_alloc();
    }

    /// An empty text, or why it cannot be done.
    std::string open(ImageModuleColours &colours)
    {
        const Profile from = profileOf(colours.from, colours.fromSize), to = profileOf(colours.to, colours.toSize);
        if (!from || !to)
            return damaged;
        colours.isGrey = cmsGetColorSpace(from.get()) == cmsSigGrayData;
        if (!colours.isGrey && cmsGetColorSpace(from.get()) != cmsSigRgbData)
            return "the colours of the profile are neither RGB nor grey";
        if (cmsGetColorSpace(to.get()) != cmsSigRgbData)
            return "the colours of the profile are not RGB";
        m_flags = colours.blackPoints ? exact | cmsFLAGS_BLACKPOINTCOMPENSATION : exact;
        m_intent = cmsUInt32Number(colours.intent);
        const cmsUInt32Number in = colours.isGrey ? greyPixels : colourPixels;
        if (!colours.proof)
            m_first = transform(from, in, to, colourPixels);
        else if (const std::string problem = openProof(colours, from, in, to); !problem.empty())
            return problem;
        if (!m_first)
            return unusable;
        colours.isSame = changesNothing(colours.isGrey);
        return {};
    }

    void apply(float *rgba, std::size_t pixels) const
    {
        constexpr std::size_t most = 1 << 10; // what lies between two steps is small, and lcms2 counts in 32 bits
        for (; pixels > 0; rgba += 4 * std::min(pixels, most), pixels -= std::min(pixels, most))
            applyTo(rgba, std::min(pixels, most));
    }

private:
    static constexpr const char *damaged = "it is no ICC profile, or is damaged";
    static constexpr const char *unusable = "lcms2 cannot convert by it";
    static constexpr cmsUInt32Number exact = cmsFLAGS_NOOPTIMIZE | cmsFLAGS_NOCACHE; // not by tables of 16 bits

    /// On the way back black points stay as they are: the device's black is seen. Colours go through the proof's own
    /// channels, where they are cut off: lcms2 by itself would carry what lies outside through the curves and back
    /// again.
    std::string openProof(const ImageModuleColours &colours, const Profile &from, cmsUInt32Number in, const Profile &to)
    {
        const Profile proof = profileOf(colours.proof, colours.proofSize);
        if (!proof)
            return damaged;
        const Channels channels(proof.get());
        if (channels.count == 0)
            return "the colours of the profile are neither RGB, grey nor CMYK";
        m_channels = channels.count, m_most = channels.most;
        m_first = transform(from, in, proof, channels.format);
        m_second.reset(cmsCreateTransformTHR(m_context.get(), proof.get(), channels.format, to.get(), colourPixels,
                                             INTENT_RELATIVE_COLORIMETRIC, exact));
        if (!m_second)
            return unusable;
        if (colours.marksGamut) {
            m_marks.reset(cmsCreateProofingTransformTHR(m_context.get(), from.get(), in, to.get(), colourPixels,
                                                        proof.get(), m_intent, INTENT_RELATIVE_COLORIMETRIC,
                                                        m_flags | cmsFLAGS_SOFTPROOFING | cmsFLAGS_GAMUTCHECK));
            if (!m_marks)
                return unusable;
        }
        return {};
    }

    void applyTo(float *rgba, std::size_t pixels) const
    {
        const auto count = cmsUInt32Number(pixels);
        if (!m_second)
            return cmsDoTransform(m_first.get(), rgba, rgba, count);
        std::vector<float> between(pixels * std::size_t(m_channels)), marks;
        cmsDoTransform(m_first.get(), rgba, between.data(), count);
        for (float &v : between)
            v = v > 0 ? std::min(v, m_most) : 0;
        if (m_marks) {
            marks.assign(rgba, rgba + 4 * pixels);
            cmsDoTransform(m_marks.get(), marks.data(), marks.data(), count);
        }
        cmsDoTransform(m_second.get(), between.data(), rgba, count);
        for (std::size_t i = 0; i < marks.size(); i += 4) // lcms2 makes -1 of all channels that it marks.
            if (marks[i] < -0.9f && marks[i + 1] < -0.9f && marks[i + 2] < -0.9f)
                std::fill_n(rgba + i, 3, -1.0f);
    }

    Profile profileOf(const void *bytes, std::size_t size) const
    {
        return {bytes ? cmsOpenProfileFromMemTHR(m_context.get(), bytes, cmsUInt32Number(size))
                      : cmsCreate_sRGBProfileTHR(m_context.get()),
                cmsCloseProfile};
    }
    Transform transform(const Profile &from, cmsUInt32Number in, const Profile &to, cmsUInt32Number out) const
    {
        return {cmsCreateTransformTHR(m_context.get(), from.get(), in, to.get(), out, m_intent, m_flags),
                cmsDeleteTransform};
    }

    /// Whether 8 bits of a channel show no difference on a grid of colours.
    bool changesNothing(bool grey) const
    {
        constexpr int steps = 16;
        const int last = grey ? 0 : steps;
        for (int r = 0; r <= steps; ++r)
            for (int g = 0; g <= last; ++g)
                for (int b = 0; b <= last; ++b) {
                    std::array<float, 4> pixel{float(r) / steps, float(grey ? r : g) / steps,
                                               float(grey ? r : b) / steps, 1};
                    const std::array<float, 4> before = pixel;
                    apply(pixel.data(), 1);
                    for (std::size_t c = 0; c < 3; ++c)
                        if (!(std::abs(pixel[c] - before[c]) < 0.5f / 255))
                            return false;
                }
        return true;
    }

    std::unique_ptr<std::remove_pointer_t<cmsContext>, void (*)(cmsContext)> m_context;
    Transform m_first{nullptr, cmsDeleteTransform};  ///< to the proof's colours, or at once to the end
    Transform m_second{nullptr, cmsDeleteTransform}; ///< from the proof's colours
    Transform m_marks{nullptr, cmsDeleteTransform};
    cmsUInt32Number m_flags = 0, m_intent = 0;
    int m_channels = 0;
    float m_most = 1;
};

} // namespace

} // namespace suffuse

extern "C" {
__attribute__((visibility("default"))) suffuse::ImageModuleSpace
suffuse_colours_name(const void *profile, std::size_t profileSize, wchar_t *name, std::size_t size)
{
    const suffuse::Profile opened(cmsOpenProfileFromMem(profile, cmsUInt32Number(profileSize)), cmsCloseProfile);
    if (!opened)
        return suffuse::ModuleNoSpace;
    const auto bytes = cmsUInt32Number(size * sizeof(wchar_t));
    if (cmsGetProfileInfo(opened.get(), cmsInfoDescription, "en", "US", name, bytes) == 0)
        name[0] = 0;
    switch (cmsGetColorSpace(opened.get())) {
    case cmsSigRgbData:
        return suffuse::ModuleRgb;
    case cmsSigGrayData:
        return suffuse::ModuleGrey;
    case cmsSigCmykData:
        return suffuse::ModuleCmyk;
    default:
        return suffuse::ModuleNoSpace;
    }
}

__attribute__((visibility("default"))) void *suffuse_colours_open(suffuse::ImageModuleColours *colours, char *error,
                                                                  std::size_t size)
{
    std::unique_ptr<suffuse::Conversion> conversion;
    const auto open = [&] {
        conversion = std::make_unique<suffuse::Conversion>();
        const std::string problem = conversion->open(*colours);
        return problem.empty() || suffuse::fail(error, size, problem);
    };
    return suffuse::guarded(open, error, size) ? conversion.release() : nullptr;
}

__attribute__((visibility("default"))) void suffuse_colours_apply(void *conversion, float *rgba, std::size_t pixels)
{
    static_cast<suffuse::Conversion *>(conversion)->apply(rgba, pixels);
}

__attribute__((visibility("default"))) void suffuse_colours_close(void *conversion)
{
    delete static_cast<suffuse::Conversion *>(conversion);
}
}
