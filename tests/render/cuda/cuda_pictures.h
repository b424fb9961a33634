// What a CUDA renderer must do with pictures as paint, on any device, emulated or real.
#pragma once

#include "tests/render/cuda/cuda_checks.h"
#include "tests/render/layers/grouped.h"
#include "tests/render/layers/pictured.h"

namespace suffuse::test {

/// Random trees of groups with pictures: as the CPU and the reference draw them, and the same bits for whoever
/// evaluates costly strokes, and however many devices share the picture.
inline void checkPicturesAsPaint(const OpenDevice &open, int from, int to)
{
    constexpr std::uint32_t never = UINT32_MAX;
    CudaRenderer cuda({open()}, 0), several({open(), open(), open()}, 0), apart({open()}, 0, true, {0, 0, 0, 0});
    CudaRenderer together({open()}, 0, true, {never, never, never, never}), uncut({open()}, 0, false);
    for (int i = from; i < to; ++i) {
        std::mt19937_64 random(unsigned(i) + 51);
        auto strokes = randomStrokes(random, 8, 72, 54);
        if (i % 4 == 0)
            strokes.push_back(randomFill(random, 9, 72, 54, i % 8 ? 0.001 : 4));
        const Paper paper{i % 3 == 0 ? PaperKind::Procedural : PaperKind::None, 5, 20, 0.8f, {}};
        const auto p = grouped(pictured(painting(std::move(strokes), 72, 54, paper), random), random);
        const View view = i % 4 == 3 ? View{{36, 27}, std::exp2(double(random() % 9) - 3), 0.4, true, 80, 61}
                                     : View::ofArea(p->canvas.area(), 72, 54);
        const bool transparent = i % 5 == 2;
        compareWithOthers(cuda, p, view, qPrintable(QStringLiteral("tree %1").arg(i)), -1, transparent);
        const FloatPicture expected = test::render(cuda, p, view, -1, transparent);
        for (CudaRenderer *renderer : {&several, &apart, &together, &uncut})
            QVERIFY2(test::render(*renderer, p, view, -1, transparent).rgba == expected.rgba,
                     qPrintable(QStringLiteral("tree %1").arg(i)));
    }
}

/// Any history of edits of pictures, strokes and groups leads to the picture that is drawn at once.
inline void checkPictureEdits(const OpenDevice &open, int steps)
{
    std::mt19937_64 random(16);
    auto p = grouped(pictured(painting(randomStrokes(random, 14, 120, 90), 120, 90), random), random);
    CudaRenderer live({open()}, 0), fresh({open()}, 0);
    const View view = View::ofArea(p->canvas.area(), 120, 90);
    FloatPicture picture;
    bool partial = false;
    for (int step = 0; step < steps; ++step) {
        p = random() % 2 ? repictured(p, random) : random() % 2 ? regrouped(p, random) : randomlyEdited(p, random);
        const bool drags = random() % 4 == 0;
        const auto stats = live.render({p, p->end(), view, false, drags}, picture);
        QVERIFY(stats);
        partial |= stats->tilesEvaluated > 0 && stats->tilesEvaluated < stats->tiles;
        if (drags)
            QVERIFY(live.render({p, p->end(), view}, picture));
        QVERIFY2(picture.rgba == test::render(fresh, p, view).rgba, qPrintable(QStringLiteral("step %1").arg(step)));
    }
    QVERIFY(partial);
}

} // namespace suffuse::test
