// The commands for the brush in hand and for brush files.
#pragma once

#include <QMenu>
#include <QPointer>

namespace suffuse {

class BrushDialog;
class Editor;

/// The menu of the Brushes dock. When it opens, it finds out which of its entries can be used.
class BrushMenu : public QMenu {
    Q_OBJECT

public:
    BrushMenu(Editor &editor, QWidget *panel);

    /// Opens the dialog with all settings of the brush in hand.
    void showDialog();

signals:
    /// Says why something could not be done, or not wholly. An empty text takes the message away.
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
    QMenu *m_apply; ///< puts parts of the brush in hand on the selection
    QPointer<BrushDialog> m_dialog;
};

} // namespace suffuse
