#include "app/panels/inspector/fill_section.h"

#include "app/panels/inspector/rows/combo_row.h"
#include "app/panels/inspector/rows/gradient_rows.h"
#include "app/session/editor.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/quantity.h"
#include "model/painting/editable.h"
#include "undo/fill_edits.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace suffuse {

namespace {

/// Segments must spread to be seen, and fills need not.
FieldSpec diffusionSpec()
{
    FieldSpec spec = specOf(Quantity::Diffusion);
    spec.toolTip = FillSection::tr("How fast the fill spreads: the spread grows with the root of D times time. 0 keeps "
                                   "its edge crisp at any zoom.");
    spec.minimum = 0;
    return spec;
}

FieldSpec densitySpec()
{
    FieldSpec spec = specOf(Quantity::Density);
    spec.name = FillSection::tr("Density ρ"); // of an area; φ of a segment is that of a line, and a length
    spec.toolTip = FillSection::tr("Density ρ deep within the fill. On its outline it is half of that, so that with 1 "
                                   "and a threshold of ½ the paint ends there.");
    spec.display.unit.clear();
    spec.sliderMinimum = 0.1;
    spec.sliderMaximum = 10;
    spec.defaultValue = 1;
    return spec;
}

} // namespace

FillSection::FillSection(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    m_filled = new QCheckBox(tr("Fill"), this);
    QFont bold = m_filled->font();
    bold.setWeight(QFont::DemiBold);
    m_filled->setFont(bold);
    m_filled->setToolTip(tr("What the stroke encloses was wetted at once, and spreads like its paint"));
    column->addWidget(m_filled);
    m_values = new QWidget(this);
    auto *values = new QVBoxLayout(m_values);
    values->setContentsMargins(0, 0, 0, 0);
    values->setSpacing(4);
    QGridLayout *grid = addFieldGrid(*values);
    addRow(diffusionSpec(), *grid, &Fill::diffusion);
    addRow(densitySpec(), *grid, &Fill::density);
    addRow(specOf(Quantity::Granulation), *grid, &Fill::granulation);
    addRow(specOf(Quantity::MaxAge), *grid, &Fill::maxAge);
    const ComboRow rule =
        ComboRow::add(*grid, grid->rowCount(), tr("Inside"),
                      tr("What is inside where the outline overlaps itself (nonzero and even-odd in SVG)"),
                      {tr("All that is enclosed"), tr("Every other area")}, m_values);
    m_ruleLabel = rule.label, m_rule = rule.box;
    m_colour = new ColourRows(true, m_values);
    values->addWidget(m_colour);
    m_gradient = new GradientRows(editor, m_values);
    values->addWidget(m_gradient);
    column->addWidget(m_values);

    connect(m_filled, &QCheckBox::clicked, this, &FillSection::fillSelected);
    connect(m_rule, &QComboBox::activated, this, [this](int index) {
        const Document &document = m_editor.document();
        m_editor.push(changeFills(document, *document.painting(), document.selection().strokes,
                                  [index](Fill &now, const Fill &) { now.rule = FillRule(index); }),
                      tr("Change fill"));
    });
    const auto channelOf = [](int channel) -> Member {
        return [channel](Fill &fill) -> float & { return ColourRows::channelOf(fill.colour, channel); };
    };
    connect(m_colour, &ColourRows::edited, this,
            [=, this](int channel, double value, ValueEntry *entry) { set(channelOf(channel), value, entry); });
    connect(m_colour, &ColourRows::editedRelative, this,
            [=, this](int channel, const ValueMap &map) { changeEach(channelOf(channel), map); });
    connect(m_colour, &ColourRows::changed, this, [=, this](int channel, const ValueChange &change, ValueEntry *entry) {
        changeTogether(channelOf(channel), change, entry);
    });
    connect(m_colour, &ColourRows::refused, this, &FillSection::refused);
    connect(m_gradient, &GradientRows::refused, this, &FillSection::refused);
}

void FillSection::addRow(const FieldSpec &spec, QGridLayout &grid, float Fill::*member)
{
    auto *field = new SliderField(spec, grid, grid.rowCount(), m_values);
    m_rows.emplace_back(member, field);
    const Member value = [member](Fill &fill) -> float & { return fill.*member; };
    connect(field, &SliderField::edited, this,
            [=, this](double number, ValueEntry *entry) { set(value, number, entry); });
    connect(field, &SliderField::editedRelative, this, [=, this](const ValueMap &map) { changeEach(value, map); });
    connect(field, &SliderField::changed, this,
            [=, this](const ValueChange &change, ValueEntry *entry) { changeTogether(value, change, entry); });
    connect(field, &SliderField::refused, this, &FillSection::refused);
}

void FillSection::showFew()
{
    m_filled->hide();
    m_ruleLabel->hide();
    m_rule->hide();
}

SliderField *FillSection::row(float Fill::*member) const
{
    const auto at = std::ranges::find(m_rows, member, &std::pair<float Fill::*, SliderField *>::first);
    return at == m_rows.end() ? nullptr : at->second;
}

void FillSection::set(const Member &member, double value, ValueEntry *entry)
{
    const Document &document = m_editor.document();
    m_editor.push(changeFills(document, *document.painting(), document.selection().strokes,
                              [&](Fill &now, const Fill &) { member(now) = float(value); }),
                  tr("Change fill"), entry);
}

void FillSection::changeEach(const Member &member, const ValueMap &map)
{
    const Document &document = m_editor.document();
    bool possible = true;
    Edit edit = changeFills(document, *document.painting(), document.selection().strokes, [&](Fill &now, const Fill &) {
        const std::optional<double> mapped = map(double(member(now)));
        possible = possible && mapped;
        member(now) = float(mapped.value_or(double(member(now))));
    });
    if (possible)
        m_editor.push(std::move(edit), tr("Change fill"));
    else
        emit refused(tr("Not possible for all that is selected: a value would be out of range."));
}

void FillSection::changeTogether(const Member &member, const ValueChange &change, ValueEntry *entry)
{
    const Document &document = m_editor.document();
    const PaintingPtr start = entry->start(document);
    m_editor.push(changeFills(document, *start, document.selection().strokes,
                              [&](Fill &now, const Fill &then) {
                                  Fill before = then;
                                  member(now) = float(change.applied(double(member(before))));
                              }),
                  tr("Change fill"), entry);
}

void FillSection::fillSelected(bool on)
{
    const Document &document = m_editor.document();
    const std::set<StrokeId> &strokes = document.selection().strokes;
    m_editor.push(on ? addFills(document, strokes) : removeFills(document, strokes),
                  on ? tr("Fill") : tr("Remove fill"));
}

/// A change that is shown is forgotten when the fills are not what it made of them any more.
void FillSection::keepChange(SliderField &row, const Inspected &inspected,
                             const std::function<double(const Fill &)> &valueOf)
{
    const Locks isLocked(inspected.painting->groups);
    row.keepChange([&, start = row.entry().start()](const ValueChange &change) {
        return std::ranges::all_of(inspected.strokes, [&](const Stroke *stroke) {
            const StrokePtr then = start ? start->find(stroke->id) : nullptr;
            if (!stroke->fill || !then || !then->fill)
                return start && !stroke->fill;
            return isLocked(*stroke) || float(valueOf(*stroke->fill)) == float(change.applied(valueOf(*then->fill)));
        });
    });
}

void FillSection::refresh(const Inspected &inspected)
{
    std::vector<const Fill *> fills;
    for (const Stroke *stroke : inspected.strokes)
        if (stroke->fill)
            fills.push_back(&*stroke->fill);
    const bool some = !fills.empty() && fills.size() < inspected.strokes.size();
    m_filled->setTristate(some);
    m_filled->setCheckState(some ? Qt::PartiallyChecked : fills.empty() ? Qt::Unchecked : Qt::Checked);
    m_values->setVisible(!fills.empty());
    if (fills.empty())
        return;
    for (const auto &[member, field] : m_rows)
        keepChange(*field, inspected, [member = member](const Fill &fill) { return double(fill.*member); });
    for (int channel = 0; channel < 4; ++channel)
        keepChange(*m_colour->row(channel), inspected,
                   [channel](const Fill &fill) { return double(ColourRows::channelOf(fill.colour, channel)); });
    for (const auto &[member, field] : m_rows)
        field->setValue(commonNumber(fills, [member = member](const Fill *fill) { return fill->*member; }));
    std::array<std::optional<double>, 4> channels;
    for (int channel = 0; channel < 4; ++channel)
        channels[std::size_t(channel)] =
            commonNumber(fills, [channel](const Fill *fill) { return ColourRows::channelOf(fill->colour, channel); });
    m_colour->setColour(channels, fills.front()->colour);
    const auto rule = commonValue(fills, [](const Fill *fill) { return fill->rule; });
    m_rule->setCurrentIndex(rule ? int(*rule) : -1);
    m_gradient->refresh(inspected);
}

} // namespace suffuse
