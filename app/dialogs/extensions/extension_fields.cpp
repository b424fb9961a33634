#include "app/dialogs/extensions/extension_fields.h"

#include "app/extensions/field_values.h"
#include "app/widgets/asking/save_name.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/numbers/decimal_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

Colour colourOf(const QJsonValue &value)
{
    const QJsonArray parts = value.toArray();
    return {float(parts[0].toDouble()), float(parts[1].toDouble()), float(parts[2].toDouble()),
            float(parts[3].toDouble())};
}

QJsonValue valueOf(const Colour &colour)
{
    return QJsonArray{double(colour.red), double(colour.yellow), double(colour.blue), double(colour.opacity)};
}

/// Behind a number: its unit, after a blank where it is a word.
QString suffixOf(const Words &unit, const QString &language)
{
    const QString text = unit.in(language);
    return text.isEmpty() || text == QStringLiteral("°") ? text : ' ' + text;
}

} // namespace

ExtensionFields::ExtensionFields(const Extension &extension, const QJsonObject &values, const QString &language,
                                 QWidget *parent)
    : QWidget(parent), m_form(new QFormLayout(this))
{
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    for (const ExtensionField &field : extension.fields) {
        const QString name = field.label.in(language), tip = field.tip.in(language);
        QWidget *row = make(field, values[field.id], language);
        QWidget *widget = m_fields.at(field.id);
        widget->setToolTip(tip);
        if (field.type == ExtensionField::Type::Switch) {
            m_form->addRow(QString(), row);
            continue;
        }
        widget->setAccessibleName(name);
        auto *label = new QLabel(name, this);
        label->setToolTip(tip);
        label->setBuddy(widget);
        m_form->addRow(label, row);
    }
}

QJsonObject ExtensionFields::values() const
{
    QJsonObject values;
    for (const auto &[id, value] : m_values)
        values[id] = value();
    return values;
}

QWidget *ExtensionFields::field(const QString &id) const
{
    const auto at = m_fields.find(id);
    return at == m_fields.end() ? nullptr : at->second;
}

/// Makes what stands in the row, and notes the field in it.
QWidget *ExtensionFields::make(const ExtensionField &field, const QJsonValue &value, const QString &language)
{
    using Type = ExtensionField::Type;
    switch (field.type) {
    case Type::Number:
        return m_fields[field.id] = makeNumber(field, value, language);
    case Type::Whole:
        return m_fields[field.id] = makeWhole(field, value, language);
    case Type::Choice:
        return m_fields[field.id] = makeChoice(field, value, language);
    case Type::Colour:
        return m_fields[field.id] = makeColour(field, value);
    case Type::File:
        return makeFile(field, field.label.in(language));
    case Type::Switch: {
        auto *box = new QCheckBox(QString(field.label.in(language)).replace('&', QLatin1String("&&")), this);
        box->setAccessibleName(field.label.in(language));
        box->setChecked(value.toBool());
        m_values[field.id] = [box] { return QJsonValue(box->isChecked()); };
        connect(box, &QCheckBox::toggled, this, &ExtensionFields::edited);
        return m_fields[field.id] = box;
    }
    case Type::Text:
        break;
    }
    auto *line = new QLineEdit(value.toString(), this);
    m_values[field.id] = [line] { return QJsonValue(line->text()); };
    connect(line, &QLineEdit::textChanged, this, &ExtensionFields::edited);
    return m_fields[field.id] = line;
}

QWidget *ExtensionFields::makeNumber(const ExtensionField &field, const QJsonValue &value, const QString &language)
{
    auto *box = new DecimalBox(this);
    box->setDecimals(field.decimals);
    box->setRange(field.least, field.most);
    box->setSingleStep(std::max(std::pow(10.0, -field.decimals),
                                std::pow(10.0, std::floor(std::log10((field.most - field.least) / 50)))));
    box->setSuffix(suffixOf(field.unit, language));
    box->setValue(value.toDouble());
    // Where nobody touched it, it is what it was, with all its digits.
    m_values[field.id] = [box, given = value.toDouble(), shown = box->value()] {
        box->interpretText();
        return QJsonValue(box->value() == shown ? given : box->value());
    };
    connect(box, &QDoubleSpinBox::valueChanged, this, &ExtensionFields::edited);
    return box;
}

QWidget *ExtensionFields::makeWhole(const ExtensionField &field, const QJsonValue &value, const QString &language)
{
    auto *box = new WholeBox(this);
    box->setRange(int(std::ceil(field.least)), int(std::floor(field.most)));
    box->setSuffix(suffixOf(field.unit, language));
    box->setValue(value.toInt());
    m_values[field.id] = [box] {
        box->interpretText();
        return QJsonValue(box->value());
    };
    connect(box, &QSpinBox::valueChanged, this, &ExtensionFields::edited);
    return box;
}

QWidget *ExtensionFields::makeChoice(const ExtensionField &field, const QJsonValue &value, const QString &language)
{
    auto *box = new QComboBox(this);
    for (const ExtensionField::Choice &choice : field.choices)
        box->addItem(choice.label.in(language), choice.id);
    box->setCurrentIndex(std::max(0, box->findData(value.toString())));
    m_values[field.id] = [box] { return QJsonValue(box->currentData().toString()); };
    connect(box, &QComboBox::currentIndexChanged, this, &ExtensionFields::edited);
    return box;
}

QWidget *ExtensionFields::makeColour(const ExtensionField &field, const QJsonValue &value)
{
    auto *rows = new ColourRows(true, this);
    const auto colour = std::make_shared<Colour>(colourOf(value));
    rows->setColour(*colour);
    m_values[field.id] = [colour] { return valueOf(*colour); };
    connect(rows, &ColourRows::edited, this, [this, rows, colour](int channel, double share) {
        ColourRows::channelOf(*colour, channel) = float(share);
        rows->setColour(*colour);
        emit edited();
    });
    return rows;
}

QWidget *ExtensionFields::makeFile(const ExtensionField &field, const QString &label)
{
    auto *row = new QWidget(this);
    auto *line = new QLineEdit(row);
    auto *button = new QPushButton(tr("&Browse…"), row);
    button->setAutoDefault(false);
    button->setToolTip(tr("Choose a folder and a name"));
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(line, 1);
    layout->addWidget(button);
    m_fields[field.id] = line;
    m_values[field.id] = [line] {
        const QString path = line->text().trimmed();
        return QJsonValue(path.isEmpty() ? path : QFileInfo(path).absoluteFilePath());
    };
    connect(line, &QLineEdit::textChanged, this, &ExtensionFields::edited);
    connect(button, &QPushButton::clicked, this, [this, line, label, saves = field.saves, endings = field.endings] {
        const FileKind kind{label, endings};
        const QString filter = endings.isEmpty() ? QString() : filterOf(kind);
        const QString path = saves ? QFileDialog::getSaveFileName(this, label, line->text(), filter, nullptr,
                                                                  QFileDialog::DontConfirmOverwrite)
                                   : QFileDialog::getOpenFileName(this, label, line->text(), filter);
        if (!path.isEmpty())
            line->setText(saves && !endings.isEmpty() ? withEnding(path, {kind}, endings.front()) : path);
    });
    return row;
}

} // namespace suffuse
