// What the dialogs that export have in common.
#pragma once

#include "model/geometry.h"

#include <QCoreApplication>
#include <QStandardPaths>
#include <QWidget>

class QGridLayout;
class QSpinBox;

namespace suffuse {

class Editor;

/// Width × height in pixels, which keep to an area's shape: only widths set the scale, and a height picks the width
/// that comes nearest.
class SizeRow : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(suffuse::ExportDialog)

public:
    /// Puts itself and its label into the grid.
    SizeRow(QGridLayout &grid, int row, int largestSide, QWidget *parent);

    void setArea(const Rect &area, double width);
    QSpinBox *widthBox() const { return m_width; }
    QSpinBox *heightBox() const { return m_height; }

private:
    void showHeight();
    void takeHeight();

    Rect m_area;
    QSpinBox *m_width = nullptr;
    QSpinBox *m_height = nullptr;
};

/// The document's name with this ending, where something was exported last, else beside the document, else in `place`.
QString suggestedExportPath(const Editor &editor, QStandardPaths::StandardLocation place, const QString &ending);

} // namespace suffuse
