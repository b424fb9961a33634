// Pictures, as papers and underlays: PNG, JPEG, TIFF, EXR, WebP, by way of the image module and OpenImageIO.
#include "fuzzing.h"

#include "render/image_io/image_io.h"

using namespace suffuse;

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const bool hasModule = imageModuleProblem().isEmpty();
    require(hasModule, "the image module is there; SUFFUSE_MODULE_DIR says where");
    int width = 0, height = 0;
    qint64 pixels = 0;
    ImageRows rows;
    rows.begin = [&](int w, int h) {
        width = w, height = h;
        require(w > 0 && h > 0 && w <= maxImageSide && h <= maxImageSide && qint64(w) * h <= maxImagePixels, "size");
    };
    rows.row = [&](const ImageRun &run) {
        pixels += run.count;
        run.forEach([&](int x, int y, const float *rgba) {
            require(x >= 0 && x < width && y >= 0 && y < height, "pixels lie in the image");
            for (int i = 0; i < 4; ++i)
                require(rgba[i] >= 0 && rgba[i] <= 1, "values lie in [0, 1]");
        });
    };
    if (readImageRows(bytesOf(data, size), QStringLiteral("a"), rows))
        require(pixels == qint64(width) * height && height > 0, "all rows came");
    return 0;
}
