// A trunk as a hand paints it, in a session.
#pragma once

#include "model/brush/stroke_builder.h"
#include "tests/app/shapes.h"

namespace suffuse {

/// A wave's session with a trunk of some two hundred and eighty segments besides, upwards from (300, 620), which is
/// selected.
struct TrunkSession : WaveSession {
    StrokeId trunk = 0;

    TrunkSession()
    {
        std::vector<PenSample> samples;
        for (int i = 0; i <= 200; ++i) {
            const double u = i / 200.0;
            samples.push_back({{300 + 30 * std::sin(5 * u) + 9 * std::sin(17 * u), 620 - 520 * u},
                               Microseconds(i) * 8000,
                               float(0.25 + 0.6 * std::sin(3 * u))});
        }
        trunk = editor().document().takeStrokeId();
        editor().push(addStrokes(editor().document(), {buildStroke(*findBrush("brush-pen"), trunk, samples)}, true),
                      "trunk");
        editor().clock().setTime(painting().end());
    }
};

} // namespace suffuse
