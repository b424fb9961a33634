#include "app/session/settings/kept_brush.h"

#include "app/session/editor.h"
#include "app/session/settings/settings.h"

namespace suffuse {

KeptBrush::KeptBrush(Editor &editor, QObject *parent) : QObject(parent), m_editor(editor)
{
    constexpr int keptMs = 500;
    m_changed.setSingleShot(true);
    m_changed.setInterval(keptMs);
    connect(&editor, &Editor::brushChanged, &m_changed, qOverload<>(&QTimer::start));
    connect(&m_changed, &QTimer::timeout, this, &KeptBrush::keep);
}

void KeptBrush::keep()
{
    m_changed.stop();
    settings::setBrush(m_editor.brush());
}

void KeptBrush::finish()
{
    if (m_changed.isActive())
        keep();
}

} // namespace suffuse
