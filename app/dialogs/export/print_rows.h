#pragma once

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QSpinBox;

namespace suffuse {

class DecimalBox;

/// Rows for the size of a picture on paper, and for its resolution. When the resolution changes, pixels or print size
/// stay, whichever was set last.
class PrintRows : public QWidget {
    Q_OBJECT

public:
    enum class Unit { Millimetres, Inches };

    /// Puts itself, the row of the resolution and their labels into the grid. `width` and `height` are those of the
    /// picture in pixels.
    PrintRows(QGridLayout &grid, int row, QSpinBox *width, QSpinBox *height, QWidget *parent);

    double dpi() const;
    void setDpi(double dpi);
    /// The picture is as large on paper as its pixels are at this resolution, and stays so when the resolution changes.
    void setPrinted(double dpi);
    QDoubleSpinBox *widthBox() const;
    QDoubleSpinBox *heightBox() const;
    QDoubleSpinBox *dpiBox() const { return m_dpi; }
    QComboBox *unitBox() const { return m_unit; }

private:
    void addPrintSize(QGridLayout &grid, int row);
    void addResolution(QGridLayout &grid, int row);
    double inch() const; ///< the length of an inch in the chosen unit
    void show();
    void takePrint(QSpinBox *pixels, const QDoubleSpinBox *print);
    void takeResolution();

    QSpinBox *m_pixelWidth;
    QSpinBox *m_pixelHeight;
    DecimalBox *m_width = nullptr;
    DecimalBox *m_height = nullptr;
    QComboBox *m_unit = nullptr;
    QDoubleSpinBox *m_dpi = nullptr;
    double m_inches = 0; ///< the width that stays, in inches; 0: the pixels stay
    bool m_setting = false;
};

} // namespace suffuse
