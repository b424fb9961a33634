// The brush in hand, as the next window and the next start find it.
#pragma once

#include <QObject>
#include <QTimer>

namespace suffuse {

class Editor;

/// Keeps an editor's brush in the settings, a moment after its last change: a slider changes it many times a second.
class KeptBrush : public QObject {
    Q_OBJECT

public:
    explicit KeptBrush(Editor &editor, QObject *parent = nullptr);

    /// Now, changed or not.
    void keep();
    /// Now, if it has changed and is not kept yet.
    void finish();

private:
    Editor &m_editor;
    QTimer m_changed;
};

} // namespace suffuse
