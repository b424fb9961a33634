// An ICC profile of sRGB (IEC 61966-2-1), version 4: three colorants adapted to D50 and one parametric curve.
#include "render/image_io/module_proxy.h"

#include <cmath>
#include <string>
#include <vector>

namespace suffuse {

namespace {

using Bytes = std::string; // gcc 12 warns of overflows in inlined vector inserts

/// s15Fixed16Number
void putFixed(Bytes &out, double v)
{
    put32(out, std::uint32_t(std::int32_t(std::lround(v * 65536))));
}

void putTag(Bytes &out, const char *four)
{
    out.append(four, 4);
}

Bytes xyz(double x, double y, double z)
{
    Bytes b;
    putTag(b, "XYZ ");
    put32(b, 0);
    putFixed(b, x), putFixed(b, y), putFixed(b, z);
    return b;
}

/// multiLocalizedUnicodeType with one English text (ASCII).
Bytes text(const std::string &ascii)
{
    Bytes b;
    putTag(b, "mluc");
    put32(b, 0), put32(b, 1), put32(b, 12);
    putTag(b, "enUS");
    put32(b, std::uint32_t(2 * ascii.size())), put32(b, 28);
    for (char c : ascii)
        b.push_back(0), b.push_back(c);
    return b;
}

/// parametricCurveType 3: (aX+b)^g above d, cX below.
Bytes srgbCurve()
{
    Bytes b;
    putTag(b, "para");
    put32(b, 0);
    put32(b, 3u << 16);
    for (double v : {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045})
        putFixed(b, v);
    return b;
}

/// Bradford adaptation from D65 to D50 (chad).
Bytes adaptation()
{
    Bytes b;
    putTag(b, "sf32");
    put32(b, 0);
    for (double v : {1.047882, 0.022918, -0.050217, 0.029587, 0.990478, -0.017075, -0.009247, 0.015075, 0.751678})
        putFixed(b, v);
    return b;
}

Bytes makeProfile()
{
    struct Part {
        std::vector<const char *> tags; ///< that share the data
        Bytes data;
    };
    const std::vector<Part> parts = {{{"desc"}, text("sRGB")},
                                     {{"cprt"}, text("Apache-2.0")},
                                     {{"wtpt"}, xyz(0.9642, 1, 0.8249)},
                                     {{"chad"}, adaptation()},
                                     {{"rXYZ"}, xyz(0.436066, 0.222488, 0.013916)},
                                     {{"gXYZ"}, xyz(0.385147, 0.716873, 0.097076)},
                                     {{"bXYZ"}, xyz(0.143066, 0.060608, 0.714096)},
                                     {{"rTRC", "gTRC", "bTRC"}, srgbCurve()}};
    std::uint32_t tags = 0;
    for (const Part &p : parts)
        tags += std::uint32_t(p.tags.size());
    Bytes table, body;
    const std::uint32_t bodyStart = 128 + 4 + 12 * tags;
    put32(table, tags);
    for (const Part &p : parts) {
        for (const char *tag : p.tags)
            putTag(table, tag), put32(table, bodyStart + std::uint32_t(body.size())),
                put32(table, std::uint32_t(p.data.size()));
        body += p.data;
        body.resize((body.size() + 3) / 4 * 4);
    }
    Bytes out;
    put32(out, bodyStart + std::uint32_t(body.size()));
    put32(out, 0);
    put32(out, 0x04300000);
    putTag(out, "mntr"), putTag(out, "RGB "), putTag(out, "XYZ ");
    put32(out, 2024u << 16 | 1), put32(out, 1u << 16), put32(out, 0); // 2024-01-01, midnight
    putTag(out, "acsp");
    out.resize(64); // platform, flags, manufacturer, model, attributes: none
    put32(out, 0);  // perceptual
    putFixed(out, 0.9642), putFixed(out, 1), putFixed(out, 0.8249);
    out.resize(128);
    return out + table + body;
}

} // namespace

const unsigned char *srgbProfile(std::size_t &size)
{
    static const Bytes profile = makeProfile();
    size = profile.size();
    return reinterpret_cast<const unsigned char *>(profile.data());
}

} // namespace suffuse
