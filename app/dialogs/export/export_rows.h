// Rows that all dialogs for exports have.
#pragma once

#include "model/geometry/geometry.h"
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

/// The part of the canvas plane that the view shows. Where the view is turned, it is a little more.
Rect shownArea(const View &view);

/// A row for the exported part of the canvas. It is chosen by name, or by its numbers, which always show it; changing a
/// number chooses them.
class AreaRow : public QWidget {
    Q_OBJECT

public:
    enum class Choice { Canvas, Painted, Selected, Shown, Numbers };

    /// Puts a label, itself and, into the row below, the numbers into the grid. `shown` is the part that the window
    /// shows.
    AreaRow(QGridLayout &grid, int row, Editor &editor, const Rect &shown, QWidget *parent);

    Choice choice() const;
    /// Chooses an area by its name. Does nothing where there is no such area because nothing is painted, or selected.
    void choose(Choice choice);
    Rect area() const;
    /// Chooses an area by its numbers.
    void setNumbers(const Rect &area);
    QComboBox *box() const { return m_box; }
    /// The numbers: left, top, width, height, in canvas units.
    const std::array<QDoubleSpinBox *, 4> &numbers() const { return m_numbers; }

signals:
    void areaChanged();

private:
    void add(const QString &name, Choice choice, const Rect &area);
    void addNumbers(QWidget *parent);
    void take();
    void showNumbers(const Rect &area);

    std::array<Rect, 4> m_areas; ///< the named areas
    QComboBox *m_box = nullptr;
    QWidget *m_line = nullptr;
    std::array<QDoubleSpinBox *, 4> m_numbers{};
};

/// The place of a named area now. It is empty where there is none, and for numbers. `shown` is the part that the window
/// shows.
Rect exportArea(AreaRow::Choice choice, Editor &editor, const Rect &shown);

/// A row for the exported moment. It is chosen by name, or by a time of the document, which always shows it; changing
/// the time chooses it.
class MomentRow : public QWidget {
    Q_OBJECT

public:
    enum class Choice { Dried, Now, Time };

    /// Puts itself and its label into the grid.
    MomentRow(QGridLayout &grid, int row, Editor &editor, QWidget *parent);

    Choice choice() const;
    Microseconds moment() const;
    /// Chooses a moment. `time` counts if the choice is a time.
    void choose(Choice choice, Microseconds time);
    QComboBox *box() const { return m_box; }
    ClockBox *clock() const { return m_clock; }

private:
    void follow();

    Editor &m_editor;
    QComboBox *m_box = nullptr;
    ClockBox *m_clock = nullptr;
};

/// A row for width × height in pixels, which keep to the shape of the area. Only a width sets the scale; a height
/// chooses the width that comes nearest to it.
class SizeRow : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(suffuse::ExportDialog)

public:
    /// Puts itself and its label into the grid.
    SizeRow(QGridLayout &grid, int row, int largestSide, QWidget *parent);

    void setArea(const Rect &area, double width);
    /// The number of pixels a unit that was asked for last.
    void setArea(const Rect &area);
    /// Sets the greatest number of pixels a side that the format can hold. More than `maxPicturePixels` in all are
    /// never drawn.
    void setLargestSide(int side);
    /// Leaves so many logical pixels free at the end of the row, where the row below has something else.
    void leaveRoom(int width);
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

/// The setting in which the folder of the last export is kept: of films and of pictures apart.
QString exportFolderKey(QStandardPaths::StandardLocation place);
/// Proposes a path: the document's name with this ending, in the folder of the last export, else beside the document,
/// else in `place`.
QString suggestedExportPath(const Editor &editor, QStandardPaths::StandardLocation place, const QString &ending);

} // namespace suffuse
