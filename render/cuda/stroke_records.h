// A stroke of the scene as the records that a device reads.
#pragma once

#include "render/cuda/records.h"
#include "render/scene.h"

#include <vector>

namespace suffuse::cuda {

/// The i-th of stroke.nodes.
NodeRecord nodeRecord(const SceneStroke &stroke, std::size_t i);
DeepRecord deepRecord(const DeepNode &node);
SmallRecord smallRecord(const SmallSegment &segment);

/// How the stroke shows; where its records lie is left at 0.
StrokeRecord strokeRecord(const SceneStroke &stroke);

/// Its chunks in order, cut to a picture of width × height pixels; `firstNode` counts from `firstNode`.
std::vector<ChunkRecord> chunksOf(const SceneStroke &stroke, std::uint32_t slot, std::uint32_t firstNode, int width,
                                  int height);

} // namespace suffuse::cuda
