#pragma once

#include "app/panels/inspector/inspected.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;

namespace suffuse {

class Editor;

/// Shows and changes what picture the selected strokes are painted with: how large it is, whether it is linked, and its
/// proportions. The section is there only while some of them are painted with one.
class PictureSection : public QWidget {
    Q_OBJECT

public:
    explicit PictureSection(Editor &editor, QWidget *parent = nullptr);

    void refresh(const Inspected &inspected);

    QLabel *size() const { return m_size; }
    QLabel *file() const { return m_file; }
    QCheckBox *linked() const { return m_linked; }
    QPushButton *relink() const { return m_relink; }
    QPushButton *proportions() const { return m_proportions; }

    /// Links a file in the place of the pictures, as the button does once one is chosen.
    void linkTo(const QString &path);

signals:
    /// Emitted when something was not possible; says why. Empty: it was.
    void refused(const QString &hint);

private:
    void choose();

    Editor &m_editor;
    QLabel *m_size = nullptr;
    QLabel *m_file = nullptr; ///< where a linked picture lies, and whether it is missing
    QCheckBox *m_linked = nullptr;
    QPushButton *m_relink = nullptr;
    QPushButton *m_proportions = nullptr;
};

} // namespace suffuse
