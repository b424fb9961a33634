#include "app/session/extensions/extension_library.h"

#include "app/extensions/field_values.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"

namespace suffuse {

namespace {

const QString disabledKey = QStringLiteral("extensions/disabled");

QString valueKey(const Extension &extension, const ExtensionField &field)
{
    return QStringLiteral("extensions/values/%1/%2").arg(extension.id, field.id);
}

} // namespace

ExtensionLibrary &ExtensionLibrary::instance()
{
    static ExtensionLibrary library;
    return library;
}

const std::vector<FoundExtension> &ExtensionLibrary::found()
{
    if (!std::exchange(m_isRead, true) || m_language != languageInUse()) {
        m_language = languageInUse();
        m_found = findExtensions(m_language);
    }
    return m_found;
}

void ExtensionLibrary::reload()
{
    m_isRead = false;
    emit changed();
}

const Extension *ExtensionLibrary::usable(const QString &id)
{
    for (const FoundExtension &each : found())
        if (each.extension && each.extension->id == id && isEnabled(id))
            return &*each.extension;
    return nullptr;
}

bool ExtensionLibrary::isEnabled(const QString &id) const
{
    return !settings::store().value(disabledKey).toStringList().contains(id);
}

void ExtensionLibrary::setEnabled(const QString &id, bool enabled)
{
    settings::updateList(disabledKey, [&](QStringList disabled) {
        disabled.removeAll(id);
        if (!enabled)
            disabled << id;
        return disabled;
    });
    emit changed();
}

QJsonObject ExtensionLibrary::valuesOf(const Extension &extension) const
{
    QJsonObject values = usualValues(extension);
    for (const ExtensionField &field : extension.fields) {
        const QVariant kept = settings::store().value(valueKey(extension, field));
        if (!kept.isValid())
            continue;
        if (const Result<QJsonValue> value = valueOfText(field, kept.toString()))
            values[field.id] = *value;
    }
    return values;
}

void ExtensionLibrary::keepValues(const Extension &extension, const QJsonObject &values)
{
    for (const ExtensionField &field : extension.fields)
        if (field.type != ExtensionField::Type::File)
            settings::store().setValue(valueKey(extension, field), textOfValue(values[field.id]));
}

QString ExtensionLibrary::lastRun(const QString &id) const
{
    const auto at = m_runs.find(id);
    return at == m_runs.end() ? QString() : at->second;
}

void ExtensionLibrary::noteRun(const Extension &extension, const ExtensionOutcome &outcome)
{
    m_last = extension.id;
    QString &run = m_runs[extension.id];
    if (outcome.cancelled)
        run = ExtensionMessages::tr("It was stopped.");
    else
        run = outcome.error.isEmpty() ? ExtensionMessages::tr("It went well.") : outcome.error;
    if (!outcome.log.trimmed().isEmpty())
        run += QStringLiteral("\n\n") + outcome.log.trimmed();
}

ExtensionOrder extensionOrder(Editor &editor, const Extension &extension, const QJsonObject &values)
{
    ExtensionOrder order;
    order.extension = extension;
    order.values = values;
    order.painting = editor.document().painting();
    order.selected = editor.selection().strokes;
    order.layer = editor.layer().isComing() ? 0 : editor.layer().group();
    order.time = editor.clock().time();
    order.language = languageInUse();
    return order;
}

bool applyExtension(Editor &editor, const ExtensionOrder &order, const ExtensionOutcome &outcome)
{
    if (!outcome.painting)
        return true;
    if (editor.document().painting() != order.painting)
        return false;
    const Microseconds now = editor.clock().time();
    const bool wasAtEnd = now >= order.painting->end();
    editor.restore(*outcome.painting, order.extension.name.in(order.language));
    if (!wasAtEnd)
        editor.clock().lookAt(now);
    return true;
}

} // namespace suffuse
