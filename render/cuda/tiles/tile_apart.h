// Some strokes cost so much at a tile that its warp would be late, as where washes of hundreds of nodes lie over each
// other. The lists' kernel gives each of them a job of its own (tile_lists.h), and a warp evaluates it here, apart from
// the tile's other strokes, into a slot of memory. The warp that paints the tile then mixes what the slot holds, as if
// it had evaluated the stroke itself: sums run over the same nodes in the same order, so no bit depends on who did.
#pragma once

#include "render/cuda/tiles/tile_general.h"

namespace suffuse::cuda {

SUFFUSE_PROGRAM Float4 *apartSlot(const Frame &frame, std::uint32_t slot)
{
    return reinterpret_cast<Float4 *>(frame.apartSamples) + std::size_t(slot) * tileSize;
}
SUFFUSE_PROGRAM std::uint32_t *apartDone(const Frame &frame, std::uint32_t slot, int part)
{
    return frame.apartDone + std::size_t(slot) * apartParts + part;
}

/// Evaluates a part of a stroke of any kind at a tile (GeneralStroke::evaluate). Its code is long, so it is called, not
/// inlined.
template <bool fills, class Warp>
SUFFUSE_CALL bool evaluateGeneral(Warp warp, const Frame &frame, const ApartJob job, int part, Levels levels,
                                  PaintScratch &paint, GeneralScratch &general)
{
    SUFFUSE_IS_LAUNCHED(frame);
    SUFFUSE_IN_SHARED(paint);
    SUFFUSE_IN_SHARED(general);
    return GeneralStroke<Warp, fills>(warp, frame, job, paint, general).evaluate(part, levels);
}

/// Does a part of a job of a general stroke.
template <bool fills, class Warp>
SUFFUSE_PROGRAM void paintApartPart(Warp &warp, const Frame &frame, const ApartJob &job, int part, PaintScratch &paint,
                                    GeneralScratch &general)
{
    warp.meet();
    warp.fetch([&](int lane, auto start) { fetchStroke(frame, job.stroke, lane, start, paint.stroke); });
    warp.arrive(false);
    const StrokeRecord &stroke = strokeOf(paint.stroke);
    if (part > 0 && !isSupersampled(stroke))
        return;
    evaluateGeneral<fills>(warp, frame, job, part, Levels::FindOwn, paint, general);
    Float4 *slot = apartSlot(frame, job.slot);
    warp.each([&](int lane) {
        SUFFUSE_ROLLED
        for (int k = 0; k < laneSamples; ++k) {
            const int at = sampleAt(lane, k);
            if (partOf(stroke, general.level[at], lane, k) == part)
                slot[at] = partSample(paint, general, part, lane, k);
        }
    });
    warp.publish(apartDone(frame, job.slot, part), 2 * frame.apartStamp + 1);
}

/// Evaluates a plain stroke that has a crisp fill.
template <class Warp>
SUFFUSE_PROGRAM void paintApartCrisp(Warp &warp, const Frame &frame, const ApartJob &job, PaintScratch &scratch)
{
    const StrokeRecord &stroke = strokeOf(scratch.stroke);
    const FillValues &fill = frame.fills[stroke.fillValues];
    const float *eta = nullptr;
    if (stroke.granulated && frame.paper.kind != 0) {
        findEta(warp, frame, job.column, job.row, Block{}, 0, scratch.eta);
        eta = scratch.eta;
    }
    NodeStream<Warp, true> nodes(warp, frame, job, scratch.fetched, scratch.sums);
    int base = 0;
    clearCover(warp, plainCover(scratch.sums));
    nodes.forEachListing(
        Block{}, [](const Listing &) {},
        [&](const Fetched &chunk, int records, Listing &) {
            base += addCover(warp, plainCover(scratch.sums), chunk, records, fill, job.column, job.row, Block{});
        });
    const bool shows = shadeCrisp(warp, frame, stroke, job.column, job.row, base, eta, scratch.sums);
    Float4 *slot = apartSlot(frame, job.slot);
    if (shows)
        warp.each([&](int lane) {
            for (int k = 0; k < laneSamples; ++k)
                slot[sampleAt(lane, k)] = paintedSamples(scratch.sums)[sampleAt(lane, k)];
        });
    warp.publish(apartDone(frame, job.slot, 0), 2 * frame.apartStamp + shows);
}

/// Does a plain job. It is called, not inlined, since painting tiles needs all registers.
template <bool fills, class Warp>
SUFFUSE_CALL void paintApartPlain(Warp warp, const Frame &frame, const ApartJob job, PaintScratch &scratch)
{
    SUFFUSE_IS_LAUNCHED(frame);
    SUFFUSE_IN_SHARED(scratch);
    warp.meet();
    warp.fetch([&](int lane, auto start) { fetchStroke(frame, job.stroke, lane, start, scratch.stroke); });
    const StrokeRecord &stroke = strokeOf(scratch.stroke);
    if constexpr (fills) {
        warp.arrive(false);
        if (stroke.fill & crispFill)
            return paintApartCrisp(warp, frame, job, scratch);
    }
    BlockStroke<Warp, fills> whole(warp, frame, job, stroke, scratch.fetched, scratch.sums);
    const bool shows = whole.evaluate(Block{}, 0, scratch.eta);
    if (shows)
        whole.store(apartSlot(frame, job.slot));
    warp.publish(apartDone(frame, job.slot, 0), 2 * frame.apartStamp + shows);
}

/// Takes jobs of general strokes, or of plain ones, and does them until none is left.
template <bool general, bool fills, class Warp, class Scratch>
SUFFUSE_PROGRAM void takeApart(Warp &warp, const Frame &frame, Scratch &scratch)
{
    const std::uint32_t *counts = frame.status + firstApartCount + (general ? costlyGeneral : costlyPlain);
    const std::uint32_t costly = counts[0], jobs = costly + counts[1];
    if (jobs == 0)
        return;
    const std::uint32_t parts = general ? generalParts : 1;
    std::uint32_t *next = frame.status + (general ? nextGeneralApart : nextPlainApart);
    for (std::uint32_t place; (place = warp.take(next)) < jobs * parts;) {
        const std::uint32_t i = place / parts, kind = (general ? costlyGeneral : costlyPlain) + (i >= costly);
        const ApartJob job = frame.apartJobs[std::size_t(kind) * frame.apartRoom + (i >= costly ? i - costly : i)];
        if constexpr (general)
            paintApartPart<fills>(warp, frame, job, int(place % parts), scratch.paint, scratch.general);
        else
            paintApartPlain<fills>(warp, frame, job, scratch.paint);
    }
}

/// Does all jobs that a warp's tiles may wait for. When it goes on to tiles, all of them have been taken, by it or by
/// warps that do not wait themselves. So the kernels may run in any order, or at the same time.
template <bool general, bool fills, class Warp, class Scratch>
SUFFUSE_PROGRAM void paintApart(Warp &warp, const Frame &frame, Scratch &scratch)
{
    if constexpr (general)
        takeApart<true, fills>(warp, frame, scratch);
    takeApart<false, fills>(warp, frame, scratch);
}

} // namespace suffuse::cuda
