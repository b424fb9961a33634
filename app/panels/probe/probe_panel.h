#pragma once

#include "model/painting/painting.h"
#include "render/probe.h"

#include <QBasicTimer>
#include <QElapsedTimer>
#include <QThreadPool>
#include <QWidget>

#include <optional>

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace suffuse {

class AgePlot;
class Editor;

/// Shows what lies under the pointer: the strokes from top to bottom with their shares of the colour, their segments
/// with their shares of the density, and the density over the stroke's age. A click on a row selects what it shows.
/// When the pointer has left the canvas, the place where it last rested is shown. A thread of its own computes the
/// newest place only.
class ProbePanel : public QWidget {
    Q_OBJECT

public:
    enum Column { NameColumn, ShareColumn, DensityColumn };

    explicit ProbePanel(Editor &editor, QWidget *parent = nullptr);
    ~ProbePanel() override;

    /// Shows a point of the canvas, which the pointer is over.
    void setPoint(Point point);
    /// To be called when the pointer leaves the canvas.
    void leaveCanvas();

    /// The place that is shown, canvas units, and where the pointer rested last.
    const std::optional<Point> &point() const { return m_point; }
    const std::optional<Point> &rested() const { return m_rested; }

    QTreeWidget *view() const { return m_view; }
    AgePlot *plot() const { return m_plot; }
    /// Whether the numbers that are shown belong to the present place and painting.
    bool isUpToDate() const { return !m_running && !m_wanted; }

    QSize sizeHint() const override { return {280, 320}; }

protected:
    void showEvent(QShowEvent *event) override;
    void timerEvent(QTimerEvent *event) override;

private:
    struct Job {
        PaintingPtr painting;
        Microseconds time = 0;
        Point point;
    };

    void want();
    void start();
    void take(const Job &job, const Result<Probe> &result);
    void showProbe(const Probe &probe);
    QTreeWidgetItem *addStroke(const ProbeStroke &stroke);
    void showAges();
    void selectRow(QTreeWidgetItem *item);

    Editor &m_editor;
    QLabel *m_place = nullptr;
    QTreeWidget *m_view = nullptr;
    AgePlot *m_plot = nullptr;
    QThreadPool m_thread;
    std::optional<Point> m_point;
    std::optional<Point> m_rested;
    QBasicTimer m_restTimer;
    QBasicTimer m_pause;
    bool m_running = false;
    bool m_wanted = false;
    Job m_shown; ///< the place and painting that the rows show
};

} // namespace suffuse
