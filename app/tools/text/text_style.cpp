#include "app/tools/text/text_style.h"

#include "app/session/settings/settings.h"
#include "model/painting/validate.h"

#include <QFontInfo>
#include <QGuiApplication>

namespace suffuse {

namespace {

QString textKey(const char *name)
{
    return QStringLiteral("tools/text/") + QLatin1String(name);
}

/// The font of the program by the name that it has itself: "Sans Serif" means another one on each machine.
QString usualFamily()
{
    return QFontInfo(QGuiApplication::font()).family();
}

} // namespace

Text storedTextStyle()
{
    const QSettings &store = settings::store();
    const Text usual;
    Text text;
    const auto number = [&](const char *name, double otherwise) {
        bool ok = false;
        const double value = store.value(textKey(name)).toDouble(&ok);
        return ok ? value : otherwise;
    };
    text.family = store.value(textKey("family"), usualFamily()).toString();
    text.weight = float(number("weight", double(usual.weight)));
    text.italic = store.value(textKey("italic"), false).toBool();
    text.size = number("size", usual.size);
    text.letterSpacing = float(number("spacing", double(usual.letterSpacing)));
    text.lineHeight = float(number("lines", double(usual.lineHeight)));
    text.alignment = TextAlignment(std::clamp(int(number("alignment", 0)), 0, 2));
    text.vertical = store.value(textKey("vertical"), false).toBool();
    if (problemOf(text).isEmpty())
        return text;
    Text sound;
    sound.family = usualFamily();
    return sound;
}

void storeTextStyle(const Text &text)
{
    QSettings &store = settings::store();
    store.setValue(textKey("family"), text.family);
    store.setValue(textKey("weight"), double(text.weight));
    store.setValue(textKey("italic"), text.italic);
    store.setValue(textKey("size"), text.size);
    store.setValue(textKey("spacing"), double(text.letterSpacing));
    store.setValue(textKey("lines"), double(text.lineHeight));
    store.setValue(textKey("alignment"), int(text.alignment));
    store.setValue(textKey("vertical"), text.vertical);
}

} // namespace suffuse
