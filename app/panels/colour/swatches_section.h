#pragma once

#include "model/painting/painting.h"

#include <QWidget>

class QToolButton;

namespace suffuse {

class Editor;
class SwatchGrid;

/// Shows the painting's swatches, and reads and writes palettes of GIMP. Swatches are part of the document, so each
/// change is an undo step.
class SwatchesSection : public QWidget {
    Q_OBJECT

public:
    explicit SwatchesSection(Editor &editor, QWidget *parent = nullptr);

    SwatchGrid *grid() const { return m_grid; }
    QToolButton *addButton() const { return m_add; }
    QToolButton *menuButton() const { return m_menu; }

    /// Appends the colours of a palette. Shows a message if the file cannot be read.
    void importPalette(const QString &path);
    /// Writes the swatches as a palette. Shows a message if that fails.
    void exportPalette(const QString &path);

private:
    void addMenu();
    void refresh();
    void push(const std::vector<Swatch> &swatches, const QString &undoText);

    Editor &m_editor;
    SwatchGrid *m_grid = nullptr;
    QToolButton *m_add = nullptr;
    QToolButton *m_menu = nullptr;
    QAction *m_export = nullptr;
    QAction *m_map = nullptr;
    QAction *m_clear = nullptr;
};

} // namespace suffuse
