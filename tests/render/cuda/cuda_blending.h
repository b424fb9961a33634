// What a CUDA renderer must do with groups that blend, on any device, emulated or real.
#pragma once

#include "tests/render/cuda/cuda_checks.h"
#include "tests/render/filled.h"
#include "tests/render/layers/grouped.h"

namespace suffuse::test {

/// Random trees of groups, of strokes and fills of all kinds: as the CPU and the reference draw them, and the same bits
/// for whoever evaluates costly strokes, and however many devices share the picture.
inline void checkBlending(const OpenDevice &open, int from, int to)
{
    constexpr std::uint32_t never = UINT32_MAX;
    CudaRenderer cuda({open()}, 0), several({open(), open(), open()}, 0), apart({open()}, 0, true, {0, 0, 0, 0});
    CudaRenderer together({open()}, 0, true, {never, never, never, never}), uncut({open()}, 0, false);
    for (int i = from; i < to; ++i) {
        std::mt19937_64 random(unsigned(i) + 31);
        auto strokes = randomStrokes(random, 8, 72, 54);
        for (StrokeId id = 9; id < 12; ++id)
            strokes.push_back(randomFill(random, id, 72, 54, id == 11 ? 0.001 : 4));
        const Paper paper{i % 3 == 0 ? PaperKind::Procedural : PaperKind::None, 5, 20, 0.8f, {}};
        auto p = std::make_shared<Painting>(*grouped(painting(std::move(strokes), 72, 54, paper), random));
        p->canvas.background = {0.1f, 0.3f, 0.05f, i % 2 ? 1 : 0.6f};
        const View view = i % 4 == 3 ? View{{36, 27}, 1.6, 0.4, true, 80, 61} : View::ofArea(p->canvas.area(), 72, 54);
        const bool transparent = i % 5 == 2;
        compareWithOthers(cuda, p, view, qPrintable(QStringLiteral("tree %1").arg(i)), -1, transparent);
        const FloatPicture expected = test::render(cuda, p, view, -1, transparent);
        for (CudaRenderer *renderer : {&several, &apart, &together, &uncut})
            QVERIFY2(test::render(*renderer, p, view, -1, transparent).rgba == expected.rgba,
                     qPrintable(QStringLiteral("tree %1").arg(i)));
    }
}

/// Any history of edits of strokes and groups leads to the picture that is drawn at once.
inline void checkBlendingEdits(const OpenDevice &open, int steps)
{
    std::mt19937_64 random(15);
    auto p = grouped(painting(randomStrokes(random, 20, 120, 90), 120, 90), random);
    CudaRenderer live({open()}, 0), fresh({open()}, 0);
    const View view = View::ofArea(p->canvas.area(), 120, 90);
    FloatPicture picture;
    bool partial = false;
    for (int step = 0; step < steps; ++step) {
        p = random() % 2 ? regrouped(p, random) : randomlyEdited(p, random);
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
