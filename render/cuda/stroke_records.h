// This makes a stroke of the scene into the records that a device reads.
#pragma once

#include "render/cuda/tiles/records.h"
#include "render/scene/scene.h"

namespace suffuse::cuda {

/// Returns the record of the i-th node of stroke.nodes.
NodeRecord nodeRecord(const SceneStroke &stroke, std::size_t i);
DeepRecord deepRecord(const DeepNode &node);
SmallRecord smallRecord(const SmallSegment &segment);

/// Says how the stroke shows. The places of its records are left at 0.
StrokeRecord strokeRecord(const SceneStroke &stroke);

/// Returns the number of chunks that its nodes make.
std::size_t nodeChunks(const SceneStroke &stroke);
/// Returns the i-th of these chunks, clipped to a picture of width × height pixels, with indices of nodes in the stroke
/// and without a slot.
ChunkRecord chunkOf(const SceneStroke &stroke, std::size_t i, int width, int height);
/// Returns the chunk for the deep nodes of a stroke.
ChunkRecord deepChunk(const SceneStroke &stroke);

} // namespace suffuse::cuda
