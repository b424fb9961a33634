// What the dialogs that export have in common.
#pragma once

#include "model/painting/geometry.h"
#include "model/painting/segment.h"

#include <QCoreApplication>
#include <QStandardPaths>
#include <QWidget>

#include <array>

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QSpinBox;

namespace suffuse {

class ClockBox;
class Editor;
struct View;

/// The part of the canvas plane that the view shows, where it is turned a little more.
Rect shownArea(const View &view);

/// Which part of the canvas: by name, or by its numbers, which always show it; changing one chooses them.
class AreaRow : public QWidget {
    Q_OBJECT

public:
    enum class Choice { Canvas, Painted, Selected, Shown, Numbers };

    /// Puts a label, itself and, into the row below, the numbers into the grid. `shown`: what the window shows.
    AreaRow(QGridLayout &grid, int row, Editor &editor, const Rect &shown, QWidget *parent);

    Choice choice() const;
    /// Does nothing where there is no such choice: nothing is painted, or selected.
    void choose(Choice choice);
    Rect area() const;
    /// An area by its numbers.
    void setNumbers(const Rect &area);
    QComboBox *box() const { return m_box; }
    /// Left, top, width, height; canvas units.
    const std::array<QDoubleSpinBox *, 4> &numbers() const { return m_numbers; }

signals:
    void areaChanged();

private:
    void add(const QString &name, Choice choice, const Rect &area);
    void addNumbers(QWidget *parent);
    void take();
    void showNumbers(const Rect &area);

    std::array<Rect, 4> m_areas; ///< but for those of numbers
    QComboBox *m_box = nullptr;
    QWidget *m_line = nullptr;
    std::array<QDoubleSpinBox *, 4> m_numbers{};
};

/// Where an area of a name lies now; empty where there is none, and for numbers. `shown`: what the window shows.
Rect exportArea(AreaRow::Choice choice, Editor &editor, const Rect &shown);

/// Which moment: by name, or a time of the document, which always shows; changing it chooses it.
class MomentRow : public QWidget {
    Q_OBJECT

public:
    enum class Choice { Dried, Now, Time };

    /// Puts itself and its label into the grid.
    MomentRow(QGridLayout &grid, int row, Editor &editor, QWidget *parent);

    Choice choice() const;
    Microseconds moment() const;
    /// `time` counts where that is the choice.
    void choose(Choice choice, Microseconds time);
    QComboBox *box() const { return m_box; }
    ClockBox *clock() const { return m_clock; }

private:
    void follow();

    Editor &m_editor;
    QComboBox *m_box = nullptr;
    ClockBox *m_clock = nullptr;
};

/// Width × height in pixels, which keep to an area's shape: only widths set the scale, and a height picks the width
/// that comes nearest.
class SizeRow : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(suffuse::ExportDialog)

public:
    /// Puts itself and its label into the grid.
    SizeRow(QGridLayout &grid, int row, int largestSide, QWidget *parent);

    void setArea(const Rect &area, double width);
    /// As many pixels a unit as were last asked for.
    void setArea(const Rect &area);
    /// A format holds so many pixels a side; more than `maxPicturePixels` in all are never drawn.
    void setLargestSide(int side);
    double scale() const { return m_scale; } ///< pixels a unit
    QSpinBox *widthBox() const { return m_width; }
    QSpinBox *heightBox() const { return m_height; }

private:
    void takeWidth();
    void showHeight();
    void takeHeight();
    void limit();

    Rect m_area;
    int m_largestSide;
    double m_scale = 1; ///< pixels a unit
    QSpinBox *m_width = nullptr;
    QSpinBox *m_height = nullptr;
};

/// The document's name with this ending, where something was exported last, else beside the document, else in `place`.
QString suggestedExportPath(const Editor &editor, QStandardPaths::StandardLocation place, const QString &ending);

} // namespace suffuse
