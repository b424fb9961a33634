// This makes the fill of a stroke into the records that a device reads.
#pragma once

#include "render/cuda/tiles/records.h"
#include "render/scene/scene_fill.h"

#include <vector>

namespace suffuse::cuda {

/// Returns the places and ends of all panels near the picture, in their order. Their bytes are those of FillRecords and
/// FillCurveRecords. A curve's two records lie side by side, at an even place.
std::vector<NodeRecord> fillRecords(const SceneFill &fill);

/// Returns the chunk of records [begin, end) of fillRecords, with the pixels at which they count in a picture of width
/// × height.
ChunkRecord fillChunkOf(const SceneFill &fill, const std::vector<NodeRecord> &records, std::size_t begin,
                        std::size_t end, int width, int height);

FillValues fillValues(const SceneFill &fill);
/// Returns the heads and entries of a deep fill's squares, as FillValues explains them.
std::vector<DeepRecord> deepFillRecords(const SceneFill &fill);

/// Puts into a stroke's record what all tiles need to know of its fill.
void noteFill(const SceneFill &fill, StrokeRecord &record);

} // namespace suffuse::cuda
