// The fields of an extension, as its manifest describes them.
#pragma once

#include "app/extensions/extension.h"

#include <QJsonObject>
#include <QWidget>

#include <functional>
#include <map>

class QFormLayout;

namespace suffuse {

/// A form with a row for each field.
class ExtensionFields : public QWidget {
    Q_OBJECT

public:
    /// `language`: of the labels. The values are those that the fields begin with.
    ExtensionFields(const Extension &extension, const QJsonObject &values, const QString &language, QWidget *parent);

    QJsonObject values() const;
    /// The widget in which a value is chosen: a DecimalBox, a WholeBox, a combo box, a check box, a line, ColourRows.
    QWidget *field(const QString &id) const;

signals:
    /// Something was chosen.
    void edited();

private:
    QWidget *make(const ExtensionField &field, const QJsonValue &value, const QString &language);
    QWidget *makeNumber(const ExtensionField &field, const QJsonValue &value, const QString &language);
    QWidget *makeWhole(const ExtensionField &field, const QJsonValue &value, const QString &language);
    QWidget *makeChoice(const ExtensionField &field, const QJsonValue &value, const QString &language);
    QWidget *makeColour(const ExtensionField &field, const QJsonValue &value);
    QWidget *makeFile(const ExtensionField &field, const QString &label);

    QFormLayout *m_form;
    std::map<QString, QWidget *> m_fields;
    std::map<QString, std::function<QJsonValue()>> m_values;
};

} // namespace suffuse
