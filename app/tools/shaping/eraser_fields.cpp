#include "app/tools/shaping/eraser_fields.h"

#include "app/session/settings/settings.h"
#include "app/tools/tool_fields.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/quantity.h"

#include <QComboBox>
#include <QHBoxLayout>

#include <utility>

namespace suffuse {

namespace {

constexpr double leastStrength = 0.05;

double numberIn(const char *key, double usual, double least, double greatest)
{
    const double value = settings::store().value(QLatin1String(key), usual).toDouble();
    return value >= least && value <= greatest ? value : usual;
}

} // namespace

EraserChoice EraserChoice::stored()
{
    EraserChoice choice;
    const QString scope = settings::store().value("eraser/scope").toString();
    const QString mode = settings::store().value("eraser/mode").toString();
    const QString soft = settings::store().value("eraser/soft").toString();
    choice.mode = mode == "cut" ? EraserMode::Cut : mode == "lift" ? EraserMode::Lift : EraserMode::Fade;
    // Before there was another soft mode than lifting, none was stored.
    choice.soft = soft == "lift" || (soft.isEmpty() && !mode.isEmpty()) ? EraserMode::Lift : EraserMode::Fade;
    choice.scope = scope == "all" ? EraserScope::All : scope == "group" ? EraserScope::Group : EraserScope::Selected;
    choice.strength = numberIn("eraser/strength", choice.strength, leastStrength, 1);
    choice.softness = numberIn("eraser/softness", choice.softness, SoftTip::leastSoftness, SoftTip::greatestSoftness);
    return choice;
}

void EraserChoice::store() const
{
    QSettings &s = settings::store();
    s.setValue("eraser/mode", mode == EraserMode::Cut ? "cut" : mode == EraserMode::Lift ? "lift" : "fade");
    s.setValue("eraser/soft", soft == EraserMode::Lift ? "lift" : "fade");
    s.setValue("eraser/scope", scope == EraserScope::All ? "all" : scope == EraserScope::Group ? "group" : "selected");
    s.setValue("eraser/strength", strength);
    s.setValue("eraser/softness", softness);
}

EraserFields::EraserFields(QHBoxLayout &row, const std::function<void()> &addSize) : QObject(row.parentWidget())
{
    m_modes = addChoices(row, {tr("Fade"), tr("Lift"), tr("Cut")},
                         tr("Fade makes paint paler, wherever it is seen; Lift takes its density away, so that edges "
                            "draw in; Cut cuts curves out"),
                         [this](int i) { change([i](EraserChoice &choice) { choice.setMode(EraserMode(i)); }); });
    row.addSpacing(10);
    addSize();
    FieldSpec strength =
        shareSpec(tr("Strength"),
                  tr("Fade: the share of the paint that is taken. Lift: how much density, so that feathered "
                     "paint gets paler and paint with a sharp edge narrower. A pen's pressure takes "
                     "from it"),
                  1);
    strength.minimum = leastStrength;
    m_strength = addNumber(row, strength, [this](double value) {
        change([value](EraserChoice &choice) { choice.strength = std::clamp(value, leastStrength, 1.0); });
    });
    FieldSpec softness = shareSpec(tr("Softness"), tr("How far what is taken away spreads, as a share of the radius"),
                                   SoftTip{}.softness);
    softness.minimum = SoftTip::leastSoftness;
    softness.maximum = SoftTip::greatestSoftness;
    m_softness = addNumber(row, softness, [this](double value) {
        change([value](EraserChoice &choice) {
            choice.softness = std::clamp(value, SoftTip::leastSoftness, SoftTip::greatestSoftness);
        });
    });
    m_scopes =
        addChoices(row, {}, tr("From which strokes; without a selection, the first choice means all"), [this](int i) {
            const auto scope = EraserScope(m_scopes->itemData(i).toInt());
            change([scope](EraserChoice &choice) { choice.scope = scope; });
        });
    showScopes();
    m_lifts = quietLabel(tr("Sharp edges draw in."), row.parentWidget());
    m_lifts->setWordWrap(false);
    row.addSpacing(10);
    row.addWidget(m_lifts);
    row.addStretch();
}

QComboBox *EraserFields::addChoices(QHBoxLayout &row, const QStringList &names, const QString &toolTip,
                                    const std::function<void(int)> &take)
{
    auto *box = new QComboBox(row.parentWidget());
    box->addItems(names);
    box->setToolTip(toolTip);
    box->setAccessibleName(toolTip);
    connect(box, &QComboBox::activated, this, take);
    row.addWidget(box);
    return box;
}

void EraserFields::change(const std::function<void(EraserChoice &)> &change)
{
    EraserChoice choice = m_choice;
    change(choice);
    show(choice);
    emit chosen(choice);
}

void EraserFields::setAnySelected(bool selected)
{
    if (std::exchange(m_anySelected, selected) != selected)
        showScopes();
}

/// While nothing is selected, two of them mean all strokes: the one that is chosen is there then.
void EraserFields::showScopes()
{
    //: scope of the eraser, while no stroke is selected
    const QString names[] = {m_anySelected ? tr("Selected Strokes") : tr("All (None Selected)"), tr("Current Group"),
                             tr("All Strokes")};
    const EraserScope unneeded = m_choice.scope == EraserScope::All ? EraserScope::Selected : EraserScope::All;
    m_scopes->clear();
    for (const EraserScope scope : {EraserScope::Selected, EraserScope::Group, EraserScope::All})
        if (m_anySelected || scope != unneeded)
            m_scopes->addItem(names[int(scope)], int(scope));
    m_scopes->setCurrentIndex(m_scopes->findData(int(m_choice.scope)));
}

void EraserFields::show(const EraserChoice &choice)
{
    m_choice = choice;
    m_modes->setCurrentIndex(int(choice.mode));
    showScopes();
    m_strength->setValue(choice.strength);
    m_softness->setValue(choice.softness);
    m_strength->setEnabled(choice.mode != EraserMode::Cut);
    m_softness->setEnabled(choice.mode != EraserMode::Cut);
    m_lifts->setVisible(choice.mode == EraserMode::Lift);
}

} // namespace suffuse
