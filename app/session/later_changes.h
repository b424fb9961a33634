// The document's changes as those hear of them who only show them: after the canvas has shown what was done.
#pragma once

#include "model/document/document.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>
#include <optional>

namespace suffuse {

/// Passes changes of the document on at once, unless the canvas is about to paint what they did: then they wait until
/// it has, and come as one. Whatever is clicked, typed or scrolled next finds everybody up to date.
class LaterChanges : public QObject {
    Q_OBJECT

public:
    explicit LaterChanges(Document &document, QObject *parent = nullptr);

    /// `waits` says whether a change is to wait for `painted`; without it none does.
    void setGate(std::function<bool(const Change &)> waits) { m_waits = std::move(waits); }
    /// What the changes did is painted: they come as soon as it is on the screen.
    void painted();
    /// Those that wait come now.
    void flush();
    bool isWaiting() const { return m_waiting.has_value(); }

signals:
    void changed(const suffuse::Change &change);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void take(const Change &change);

    std::function<bool(const Change &)> m_waits;
    std::optional<Change> m_waiting;
    QTimer m_due;
    QElapsedTimer m_clock;
    qint64 m_restsUntil = 0; ///< milliseconds of the clock
};

} // namespace suffuse
