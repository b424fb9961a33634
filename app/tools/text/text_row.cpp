#include "app/tools/text/text_row.h"

#include "app/tools/text/font_box.h"
#include "app/tools/tool_fields.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/quantity.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>

namespace suffuse {

namespace {

/// The weights that fonts have names for.
constexpr std::array weights{100, 300, 400, 500, 600, 700, 900};

int nearestWeight(float weight)
{
    int best = 0;
    for (int i = 1; i < int(weights.size()); ++i)
        if (std::abs(float(weights[std::size_t(i)]) - weight) < std::abs(float(weights[std::size_t(best)]) - weight))
            best = i;
    return best;
}

QComboBox *addBox(QHBoxLayout &row, const char *name, const QStringList &items, const QString &toolTip)
{
    auto *box = new QComboBox(row.parentWidget());
    box->setObjectName(QLatin1String(name));
    box->addItems(items);
    box->setToolTip(toolTip);
    box->setAccessibleName(toolTip);
    row.addWidget(box);
    return box;
}

QToolButton *addButton(QHBoxLayout &row, const char *name, const QString &text, const QString &toolTip)
{
    auto *button = new QToolButton(row.parentWidget());
    button->setObjectName(QLatin1String(name));
    button->setText(text);
    button->setToolTip(toolTip);
    row.addWidget(button);
    return button;
}

} // namespace

TextRow::TextRow(QWidget *parent) : QWidget(parent)
{
    QHBoxLayout *row = toolRow(this);
    m_family = new FontBox(this);
    m_family->setObjectName("family");
    m_family->setToolTip(tr("Font"));
    m_family->setAccessibleName(tr("Font"));
    row->addWidget(m_family);
    connect(m_family, &FontBox::chosen, this,
            [this](const QString &family) { emitChange([family](Text &text) { text.family = family; }); });
    m_weight = addBox(*row, "weight",
                      {tr("Thin"), tr("Light"), tr("Regular"), tr("Medium"), tr("Semibold"), tr("Bold"), tr("Black")},
                      tr("How strong the letters are"));
    connect(m_weight, &QComboBox::activated, this, [this](int index) {
        emitChange([index](Text &text) { text.weight = float(weights[std::size_t(index)]); });
    });
    m_italic = new QCheckBox(tr("Italic"), this);
    m_italic->setObjectName("italic");
    row->addWidget(m_italic);
    connect(m_italic, &QCheckBox::clicked, this,
            [this](bool on) { emitChange([on](Text &text) { text.italic = on; }); });
    row->addSpacing(10);

    const auto add = [&](const char *name, const FieldSpec &spec, auto member) {
        NumberField *field = addNumber(*row, spec, [this, member](double value) {
            emitChange(
                [member, value](Text &text) { text.*member = std::remove_reference_t<decltype(text.*member)>(value); });
        });
        field->setObjectName(QLatin1String(name));
        return field;
    };
    m_size = add("size", {tr("Size"), tr("The em of the font"), lengthDisplay(), 0.01, 1e6}, &Text::size);
    FieldSpec spacing = shareSpec(tr("Spacing"), tr("Room that is added between letters, of the size"));
    spacing.minimum = -1;
    spacing.maximum = 10;
    m_spacing = add("spacing", spacing, &Text::letterSpacing);
    FieldSpec lines = shareSpec(tr("Lines"), tr("From one line to the next, of the size"), 1.2);
    lines.maximum = 10;
    m_lines = add("lines", lines, &Text::lineHeight);
    m_alignment = addBox(*row, "alignment", {tr("Start"), tr("Centre"), tr("End")},
                         tr("Where lines lie: they begin at the text's place, are centred on it, or end there"));
    connect(m_alignment, &QComboBox::activated, this,
            [this](int index) { emitChange([index](Text &text) { text.alignment = TextAlignment(index); }); });
    m_vertical = new QCheckBox(tr("Vertical"), this);
    m_vertical->setObjectName("vertical");
    m_vertical->setToolTip(tr("Lines run from top to bottom, and follow each other from right to left"));
    row->addWidget(m_vertical);
    connect(m_vertical, &QCheckBox::clicked, this,
            [this](bool on) { emitChange([on](Text &text) { text.vertical = on; }); });
    row->addSpacing(10);
    m_bend = addButton(*row, "bend", tr("On Selected Stroke"),
                       tr("Set the text along the selected stroke, which it follows from then on"));
    connect(m_bend, &QAbstractButton::clicked, this, &TextRow::bendWanted);
    m_straighten = addButton(*row, "straighten", tr("Straight"), tr("Take the text off its curve"));
    connect(m_straighten, &QAbstractButton::clicked, this, &TextRow::straightenWanted);
    row->addStretch();
}

void TextRow::emitChange(Change change)
{
    emit changed(change);
    emit done();
}

void TextRow::show(const Text &text, bool hasFamily, bool canBend)
{
    m_family->setFamily(text.family);
    m_family->setToolTip(hasFamily ? tr("Font") : tr("Font: it is not installed here, and another one stands in"));
    m_weight->setCurrentIndex(nearestWeight(text.weight));
    m_italic->setChecked(text.italic);
    m_size->setValue(text.size);
    m_spacing->setValue(double(text.letterSpacing));
    m_lines->setValue(double(text.lineHeight));
    m_alignment->setCurrentIndex(int(text.alignment));
    m_vertical->setChecked(text.vertical);
    m_vertical->setEnabled(text.curve.empty());
    m_bend->setEnabled(canBend);
    m_straighten->setEnabled(!text.curve.empty());
}

} // namespace suffuse
