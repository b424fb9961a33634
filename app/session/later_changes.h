// The document's changes as those hear of them who only show them: after the canvas has shown what was done.
#pragma once

#include "model/document/document.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <optional>

namespace suffuse {

/// Passes changes of the document on at once, unless the canvas is about to paint what they did: then they wait until
/// it has, and come as one; of a gesture now and then. Whoever is about to act on a panel has them flushed.
class LaterChanges : public QObject {
    Q_OBJECT

public:
    explicit LaterChanges(Document &document, QObject *parent = nullptr);

    /// A canvas on the screen shows what is done, and says so by `painted`. Without one no change waits.
    void setCanvasShown(bool shown) { m_canvasShown = shown; }
    void setGestureOpen(bool open) { m_gestureOpen = open; }
    /// What the changes did is painted: they come as soon as it is on the screen.
    void painted();
    /// Those that wait come now.
    void flush();
    bool isWaiting() const { return m_waiting.has_value(); }
    /// Changes are being passed on: what is asked for now is the document as they left it.
    bool isTelling() const { return m_telling; }

signals:
    void changed(const suffuse::Change &change);

private:
    void take(const Change &change);
    void tell(const Change &change);
    bool waits(const Change &change) const;

    bool m_canvasShown = false;
    bool m_gestureOpen = false;
    bool m_telling = false;
    std::optional<Change> m_waiting;
    QTimer m_due;
    QElapsedTimer m_clock;
    qint64 m_restsUntil = 0; ///< milliseconds of the clock
};

} // namespace suffuse
