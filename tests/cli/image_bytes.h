// What tests of image files put into them.
#pragma once

#include "render/renderer.h"

#include <QByteArray>

namespace suffuse {

/// A ramp of every channel; alpha from 0 to 1.
inline FloatPicture ramp(int width, int height)
{
    FloatPicture p;
    p.resize(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float *v = p.rgba.data() + (std::size_t(y) * width + x) * 4;
            v[0] = float(x) / float(width - 1);
            v[1] = float(y) / float(height - 1);
            v[2] = 0.03f;
            v[3] = float(x + y) / float(width + height - 2);
        }
    return p;
}

/// As most formats of images write numbers.
inline QByteArray bigEndian(quint32 v)
{
    QByteArray b(4, 0);
    for (int i = 0; i < 4; ++i)
        b[i] = char(v >> (24 - 8 * i));
    return b;
}

} // namespace suffuse
