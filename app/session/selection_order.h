// The order in which strokes were selected.
#pragma once

#include "model/document/document.h"

#include <vector>

namespace suffuse {

/// Remembers in which order strokes were selected, which a document's selection does not. Of strokes that were selected
/// at once the topmost counts.
class SelectionOrder : public QObject {
    Q_OBJECT

public:
    explicit SelectionOrder(const Document &document, QObject *parent = nullptr);

    /// Both are 0 where nothing is selected.
    StrokeId first() const;
    StrokeId last() const;

private:
    void follow(const Change &change);
    StrokeId topmostOf(const std::vector<StrokeId> &strokes) const;

    const Document &m_document;
    /// The strokes that were selected at once, step by step. No step is empty, and each is sorted.
    std::vector<std::vector<StrokeId>> m_steps;
};

} // namespace suffuse
