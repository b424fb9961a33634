// Which strokes were selected first and last.
#pragma once

#include "model/document/document.h"

#include <vector>

namespace suffuse {

/// Follows a document's selection, which itself has no order. Of strokes that were selected at once the topmost counts.
class SelectionOrder : public QObject {
    Q_OBJECT

public:
    explicit SelectionOrder(const Document &document, QObject *parent = nullptr);

    /// 0 where nothing is selected.
    StrokeId first() const;
    StrokeId last() const;

private:
    void follow(const Change &change);
    StrokeId topmostOf(const std::vector<StrokeId> &strokes) const;

    const Document &m_document;
    std::vector<std::vector<StrokeId>> m_steps; ///< what was selected at once; none is empty, each is sorted
};

} // namespace suffuse
