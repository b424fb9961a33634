#include "app/dialogs/fit/fit_rows.h"

#include "app/session/settings/settings.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/quantity.h"
#include "app/widgets/numbers/slider_field.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>
#include <cmath>

namespace suffuse {

namespace {

constexpr int usualStrokes = 256, usualPaints = 8;
constexpr double mostWidth = 1e5, mostSeed = 4294967295.0;

/// How long a fit takes and how fine the picture is that it sees.
struct Detail {
    int steps, pixels;
};
constexpr std::array details{Detail{300, 150'000}, Detail{1200, 600'000}, Detail{4000, 600'000}};
enum DetailChoice { Quick, Good };

enum ColourChoice { AllColours, Palette };

FieldSpec strokesSpec()
{
    FieldSpec spec;
    spec.name = FitRows::tr("Strokes");
    spec.toolTip = FitRows::tr("At most so many. More of them go on with those that are there; fewer begin anew.");
    spec.display.decimals = 0;
    spec.minimum = 1, spec.maximum = FitRows::mostStrokes;
    spec.sliderMinimum = 16, spec.sliderMaximum = 4096;
    spec.logarithmic = true;
    spec.defaultValue = usualStrokes;
    return spec;
}

QVariant stored(const char *key, const QVariant &usual)
{
    return settings::store().value(QStringLiteral("fit/") + QLatin1String(key), usual);
}

void store(const char *key, const QVariant &value)
{
    settings::store().setValue(QStringLiteral("fit/") + QLatin1String(key), value);
}

/// A number that somebody may have written into the file of the settings.
double storedNumber(const char *key, double usual, double least, double most)
{
    const double value = stored(key, usual).toDouble();
    return value >= least && value <= most ? value : usual;
}

void choose(QComboBox &box, const char *key, int usual)
{
    const int index = stored(key, usual).toInt();
    box.setCurrentIndex(index >= 0 && index < box.count() ? index : usual);
}

} // namespace

FitRows::FitRows(QWidget *parent) : QWidget(parent)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    QGridLayout *grid = addFieldGrid(*column);
    grid->setVerticalSpacing(8);
    addStrokes(*grid);
    addChoices(*grid);
    addMore(*grid);
}

void FitRows::addStrokes(QGridLayout &grid)
{
    m_strokes = new SliderField(strokesSpec(), grid, grid.rowCount(), this);
    m_strokes->number()->setInteger(true);
    m_strokes->setValue(storedNumber("strokes", usualStrokes, 1, mostStrokes));
    connect(m_strokes, &SliderField::edited, this, [this](double value, ValueEntry *entry) {
        m_strokes->setValue(std::round(value));
        if (!entry || !entry->isDragging())
            emit changed();
    });
    connect(m_strokes, &SliderField::dragEnded, this, &FitRows::changed);
    connect(m_strokes, &SliderField::refused, this, &FitRows::refused);
}

void FitRows::addChoices(QGridLayout &grid)
{
    m_detail = addCombo(grid, tr("Detail"), tr("How much is done for each stroke. Better goes on with what is there."),
                        {tr("Quick"), tr("Good"), tr("Best")});
    choose(*m_detail, "detail", Quick);
    m_style = addCombo(grid, tr("Style"), tr("Of all strokes. Another one begins anew."), styleNames());
    choose(*m_style, "style", int(StyleKind::Feathering));
    m_colours = addCombo(grid, tr("Colours"), tr("Each stroke its own, or a few paints, which become linked swatches"),
                         {tr("All"), tr("Few paints")});
    choose(*m_colours, "colours", AllColours);
    m_paints = addNumber(grid, tr("Paints"), tr("So many colours in all"), 1, 256, true);
    m_paints->setValue(storedNumber("paints", usualPaints, 1, 256));
    const auto showPaints = [this] { m_paints->setEnabled(m_colours->currentIndex() == Palette); };
    connect(m_colours, &QComboBox::currentIndexChanged, this, showPaints);
    showPaints();
}

void FitRows::addMore(QGridLayout &grid)
{
    m_more = new QToolButton(this);
    m_more->setText(tr("More"));
    m_more->setCheckable(true);
    m_more->setAutoRaise(true);
    m_more->setFocusPolicy(Qt::TabFocus);
    m_more->setToolTip(tr("Widths of strokes, and the roll of the dice"));
    m_more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_more->setArrowType(Qt::RightArrow);
    grid.addWidget(m_more, grid.rowCount(), 0, 1, 3, Qt::AlignLeft);
    const int first = grid.rowCount();
    m_least =
        addNumber(grid, tr("Least width"), tr("No stroke is narrower; 0: as narrow as it likes"), 0, mostWidth, false);
    m_greatest =
        addNumber(grid, tr("Greatest width"), tr("No stroke is wider; 0: as wide as it likes"), 0, mostWidth, false);
    m_seed =
        addNumber(grid, tr("Seed"), tr("Another number gives other strokes, equally good ones"), 0, mostSeed, true);
    m_least->setDisplay(lengthDisplay());
    m_greatest->setDisplay(lengthDisplay());
    m_least->setValue(0);
    m_greatest->setValue(0);
    m_seed->setValue(1);
    const auto showMore = [this, &grid, first](bool on) {
        m_more->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
        for (int row = first; row < grid.rowCount(); ++row)
            for (const int column : {0, 2})
                if (QLayoutItem *item = grid.itemAtPosition(row, column))
                    item->widget()->setVisible(on);
    };
    connect(m_more, &QToolButton::toggled, this, showMore);
    showMore(false);
}

QComboBox *FitRows::addCombo(QGridLayout &grid, const QString &name, const QString &tip, const QStringList &items)
{
    auto *box = new QComboBox(this);
    box->addItems(items);
    box->setAccessibleName(name);
    box->setToolTip(tip);
    auto *label = new QLabel(name, this);
    label->setToolTip(tip);
    label->setBuddy(box);
    const int row = grid.rowCount();
    grid.addWidget(label, row, 0);
    grid.addWidget(box, row, 1, 1, 2);
    connect(box, &QComboBox::activated, this, &FitRows::changed);
    return box;
}

NumberField *FitRows::addNumber(QGridLayout &grid, const QString &name, const QString &tip, double least, double most,
                                bool isWhole)
{
    auto *field = new NumberField(this);
    field->setRange(least, most);
    if (isWhole) {
        field->setInteger(true);
        field->setStep(1);
    }
    field->setAccessibleName(name);
    field->setToolTip(tip);
    auto *label = new QLabel(name, this);
    label->setToolTip(tip);
    label->setBuddy(field);
    const int row = grid.rowCount();
    grid.addWidget(label, row, 0, 1, 2);
    grid.addWidget(field, row, 2);
    const auto take = [this, field](double value) {
        field->setValue(value);
        if (wish().greatestWidth > 0 && wish().greatestWidth < wish().leastWidth)
            emit refused(tr("The greatest width is below the least one."));
        else
            emit changed();
    };
    connect(field, &NumberField::entered, this, take);
    connect(field, &NumberField::stepped, this, take);
    connect(field, &NumberField::refused, this, &FitRows::refused);
    return field;
}

void FitRows::aimBelow(int strokes)
{
    const int usual = std::max(1, strokes / 4);
    m_strokes->setSliderRange(1, std::max(2, strokes));
    m_strokes->setDefaultValue(usual);
    m_strokes->setValue(usual);
}

FitWish FitRows::wish() const
{
    const Detail &detail = details[std::size_t(std::max(0, m_detail->currentIndex()))];
    FitWish wish;
    wish.strokes = int(m_strokes->number()->value().value_or(usualStrokes));
    wish.steps = detail.steps;
    wish.pixels = detail.pixels;
    wish.style = StyleKind(std::max(0, m_style->currentIndex()));
    wish.paints = m_colours->currentIndex() == Palette ? int(m_paints->value().value_or(usualPaints)) : 0;
    wish.leastWidth = m_least->value().value_or(0);
    wish.greatestWidth = m_greatest->value().value_or(0);
    wish.seed = std::uint64_t(m_seed->value().value_or(1));
    return wish;
}

void FitRows::remember() const
{
    store("strokes", wish().strokes);
    store("detail", m_detail->currentIndex());
    store("style", m_style->currentIndex());
    store("colours", m_colours->currentIndex());
    store("paints", m_paints->value().value_or(usualPaints));
}

} // namespace suffuse
