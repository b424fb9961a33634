#include "undo/lettering/text_layout.h"

#include "undo/lettering/text_setter.h"

namespace suffuse {

LaidText TextLayout::lay(const Text &text)
{
    LaidText out = *layText(text, m_shaper);     // A LineShaper shapes every line.
    if (m_family != text.family || !m_isKnown) { // Asking for all families takes longer than setting a text.
        m_family = text.family;
        m_isKnown = true;
        m_hasFamily = m_shaper.hasFamily(text.family);
    }
    out.hasFamily = m_hasFamily;
    return out;
}

} // namespace suffuse
