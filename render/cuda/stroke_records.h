// A stroke of the scene as the records that a device reads.
#pragma once

#include "render/cuda/records.h"
#include "render/scene/scene.h"

namespace suffuse::cuda {

/// The record of the i-th node of stroke.nodes.
NodeRecord nodeRecord(const SceneStroke &stroke, std::size_t i);
DeepRecord deepRecord(const DeepNode &node);
SmallRecord smallRecord(const SmallSegment &segment);

/// How the stroke shows. The places of its records are left at 0.
StrokeRecord strokeRecord(const SceneStroke &stroke);

/// The number of chunks that its nodes make.
std::size_t nodeChunks(const SceneStroke &stroke);
/// The i-th of these chunks, clipped to a picture of width × height pixels, with indices of nodes in the stroke and
/// without a slot.
ChunkRecord chunkOf(const SceneStroke &stroke, std::size_t i, int width, int height);
/// The chunk for the deep nodes of a stroke.
ChunkRecord deepChunk(const SceneStroke &stroke);

} // namespace suffuse::cuda
