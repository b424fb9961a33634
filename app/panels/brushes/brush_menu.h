// What can be done with the brush in hand and with brush files.
#pragma once

#include <QMenu>
#include <QPointer>

namespace suffuse {

class BrushDialog;
class Editor;

/// The menu of the brushes dock; it knows when it opens what can be done.
class BrushMenu : public QMenu {
    Q_OBJECT

public:
    BrushMenu(Editor &editor, QWidget *panel);

    /// All settings of the brush in hand.
    void showDialog();

signals:
    /// Why something could not be done, or not all of it; empty: nothing more is to be said.
    void noted(const QString &text);

private:
    void fill();
    QString inHand() const;
    void saveChanges();
    void saveAsNew();
    void rename();
    void remove();
    void import();
    void exportBrush();

    Editor &m_editor;
    QWidget *m_panel;
    QPointer<BrushDialog> m_dialog;
};

} // namespace suffuse
