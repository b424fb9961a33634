#include "app/dialogs/recolour_dialog.h"

#include "app/session/colour_convert.h"
#include "app/session/editor.h"
#include "app/widgets/colour/colour_wheel.h"
#include "app/widgets/colour/swatch_grid.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/section.h"
#include "app/widgets/look/theme.h"
#include "app/widgets/numbers/slider_field.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QTreeWidget>

namespace suffuse {

namespace {

constexpr QSize colourSize(28, 16);
constexpr int mostSwatchHeight = 66; ///< three rows; more are scrolled
enum ListColumn { BeforeColumn, AfterColumn, PaintColumn, StrokesColumn, SegmentsColumn };

QIcon iconOf(const Colour &colour, qreal ratio)
{
    QPixmap picture(colourSize * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(toOpaqueScreen(colour));
    QPainter painter(&picture);
    painter.setPen(edgeOfColours());
    painter.drawRect(QRectF(QPointF(), colourSize).adjusted(0.5, 0.5, -0.5, -0.5));
    painter.end();
    QIcon icon;
    for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected}) // The selection tints no colour.
        icon.addPixmap(picture, mode);
    return icon;
}

FieldSpec shiftSpec(const QString &name, const QString &tip, double least, double most, double usual)
{
    FieldSpec spec{.name = name, .toolTip = tip, .display = shareDisplay()};
    spec.minimum = spec.sliderMinimum = least;
    spec.maximum = spec.sliderMaximum = most;
    spec.step = spec.sliderStep = 0.01;
    spec.defaultValue = usual;
    return spec;
}

} // namespace

RecolourDialog::RecolourDialog(Editor &editor, QWidget *parent) : QDialog(parent), m_recolouring(editor)
{
    setWindowTitle(tr("Recolour Artwork"));
    setHelpPage(*this, "colour");
    auto *outer = new QVBoxLayout(this);
    auto *top = new QHBoxLayout;
    top->setSpacing(12);
    top->addWidget(makeList(), 1);
    auto *column = new QVBoxLayout;
    addColour(*column, editor.document().painting()->swatches);
    top->addLayout(column);
    outer->addLayout(top, 1);
    addShift(*outer);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    outer->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    EntryField::letReturnShowFirst(*this);
    giveMnemonics(*this);
    showResults();
    if (m_list->topLevelItemCount() > 0)
        m_list->setCurrentItem(m_list->topLevelItem(0));
    m_list->setFocus();
}

QWidget *RecolourDialog::makeList()
{
    auto *side = new QWidget(this);
    auto *column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(sectionTitle(
        m_recolouring.isOfSelection() ? tr("Colours of what is selected") : tr("Colours of the painting"), this));
    m_list = new QTreeWidget(this);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setIconSize(colourSize);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setAccessibleName(tr("Colours"));
    m_list->setToolTip(tr("The colours with the most paint come first. Choose one, or several, and give it another "
                          "colour: it changes everywhere."));
    m_list->setHeaderLabels({tr("Before"), tr("After"), tr("Paint"), tr("Strokes"), tr("Segments")});
    const QLocale locale;
    for (const ColourUse &use : m_recolouring.uses()) {
        auto *item = new QTreeWidgetItem(m_list);
        item->setIcon(BeforeColumn, iconOf(use.colour, devicePixelRatioF()));
        item->setText(BeforeColumn, toOpaqueScreen(use.colour).name());
        if (use.members.size() > 1)
            item->setToolTip(BeforeColumn, tr("%n colours that look alike", "", int(use.members.size())));
        item->setText(PaintColumn, shareDisplay().text(use.paint));
        item->setText(StrokesColumn, locale.toString(qulonglong(use.strokes)));
        item->setText(SegmentsColumn, locale.toString(qulonglong(use.segments)));
        for (const ListColumn number : {PaintColumn, StrokesColumn, SegmentsColumn})
            item->setTextAlignment(number, Qt::AlignRight | Qt::AlignVCenter);
    }
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    int widest = 0; // Columns of short numbers are as wide as their names.
    for (int i = 0; i < m_list->columnCount(); ++i)
        widest = std::max(widest, m_list->header()->fontMetrics().horizontalAdvance(m_list->headerItem()->text(i)));
    m_list->header()->setMinimumSectionSize(widest + 8);
    constexpr int rows = 8;
    m_list->setMinimumSize(widthOfColumns(), rows * fontMetrics().height());
    column->addWidget(m_list, 1);
    connect(m_list, &QTreeWidget::itemSelectionChanged, this, &RecolourDialog::showColour);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &RecolourDialog::showColour);
    return side;
}

/// The width at which no column of the list is cut off.
int RecolourDialog::widthOfColumns() const
{
    const QAbstractItemView &view = *m_list;
    const QHeaderView &header = *m_list->header();
    const auto widthOf = [&](int column) {
        return std::max({view.sizeHintForColumn(column), header.sectionSizeHint(column), header.minimumSectionSize()});
    };
    int width = 2 * m_list->frameWidth() + m_list->style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    for (int i = 0; i < m_list->columnCount(); ++i)
        width += widthOf(i == AfterColumn ? BeforeColumn : i); // Both show a colour; the results are not there yet.
    return width;
}

void RecolourDialog::addColour(QVBoxLayout &column, const std::vector<Swatch> &swatches)
{
    m_wheel = new ColourWheel(this);
    m_wheel->setFixedWidth(m_wheel->sizeHint().width());
    column.addWidget(m_wheel, 0, Qt::AlignHCenter);
    auto *row = new QHBoxLayout;
    auto *label = new QLabel(tr("Hex"), this);
    m_hex = new EntryField(this);
    m_hex->setAccessibleName(tr("Hex"));
    m_hex->setToolTip(tr("sRGB colour as #rrggbb, #rgb or CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal"));
    m_hex->setFixedWidth(m_hex->fontMetrics().horizontalAdvance("#ddddddd") + 18);
    label->setBuddy(m_hex);
    row->addWidget(label);
    row->addWidget(m_hex);
    row->addStretch();
    column.addLayout(row);
    m_hint = new HintLabel(this);
    column.addWidget(m_hint);
    m_swatches = new SwatchGrid(false, this);
    m_swatches->setAccessibleName(tr("Swatches"));
    m_swatches->setToolTip(tr("The swatches of the painting. Click: the chosen colour becomes this one."));
    m_swatches->setSwatches(swatches);
    m_swatches->showAll();
    m_swatches->installEventFilter(this);
    auto *scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(m_swatches);
    scroll->setFixedHeight(std::min(m_swatches->heightForWidth(m_wheel->width()), mostSwatchHeight));
    scroll->setVisible(!swatches.empty());
    column.addWidget(scroll);
    m_keeps = new QCheckBox(tr("Keep differences"), this);
    m_keeps->setToolTip(tr("Colours that are one line in the list change together and stay different. Else they become "
                           "the same."));
    m_keeps->setChecked(m_recolouring.keepsDifferences());
    column.addWidget(m_keeps);
    m_reset = new QPushButton(tr("Reset the Colour"), this);
    m_reset->setToolTip(tr("Gives the chosen colours back what they were"));
    m_reset->setAutoDefault(false);
    column.addWidget(m_reset);
    column.addStretch(1);
    connect(m_wheel, &ColourWheel::picked, this, &RecolourDialog::give);
    connect(m_wheel, &ColourWheel::finished, this, [this] { m_recolouring.rest(); });
    connect(m_hex, &EntryField::typed, this, &RecolourDialog::takeHex);
    connect(m_swatches, &SwatchGrid::picked, this, [this](const Colour &colour) {
        give(colour);
        m_recolouring.rest();
        showColour();
    });
    connect(m_keeps, &QCheckBox::toggled, this, [this](bool on) {
        m_recolouring.setKeepsDifferences(on);
        m_recolouring.rest();
        showResults();
    });
    connect(m_reset, &QPushButton::clicked, this, [this] {
        m_recolouring.set(chosen(), {});
        m_recolouring.rest();
        showResults();
        showColour();
    });
}

void RecolourDialog::addShift(QVBoxLayout &column)
{
    column.addWidget(sectionTitle(tr("All colours"), this));
    QGridLayout *grid = addFieldGrid(column);
    FieldSpec turn = shiftSpec(tr("Hue"), tr("Turns all hues around the colour wheel"), -0.5, 0.5, 0);
    turn.display = {.unit = QStringLiteral("°"), .factor = 360, .decimals = 0};
    turn.step = turn.sliderStep = 1.0 / 360;
    m_hue = addRow(turn, *grid, &ColourShift::hue);
    m_saturation = addRow(shiftSpec(tr("Saturation"), tr("100 %: as it is; 0 %: grey; more: more colourful"), 0, 2, 1),
                          *grid, &ColourShift::saturation);
    m_lightness = addRow(shiftSpec(tr("Lightness"), tr("Above 0 % nearer to white, below nearer to black"), -1, 1, 0),
                         *grid, &ColourShift::lightness);
    m_maps = new QCheckBox(tr("Map to the nearest swatches"), this);
    m_maps->setToolTip(tr("Each colour becomes the swatch of the painting that looks nearest"));
    m_maps->setEnabled(m_recolouring.hasSwatches());
    column.addWidget(m_maps);
    connect(m_maps, &QCheckBox::toggled, this, [this](bool on) {
        m_recolouring.setMapped(on);
        m_recolouring.rest();
        showResults();
        showColour();
    });
}

SliderField *RecolourDialog::addRow(const FieldSpec &spec, QGridLayout &grid, double ColourShift::*member)
{
    auto *field = new SliderField(spec, grid, grid.rowCount(), this);
    field->setValue(m_recolouring.shift().*member);
    connect(field, &SliderField::edited, this, [this, field, member](double value, ValueEntry *entry) {
        ColourShift shift = m_recolouring.shift();
        shift.*member = value;
        m_recolouring.setShift(shift);
        if (!entry || !entry->isDragging())
            m_recolouring.rest();
        field->setValue(value);
        showResults();
        showColour();
    });
    connect(field, &SliderField::dragEnded, this, [this] { m_recolouring.rest(); });
    connect(field, &SliderField::refused, m_hint, &HintLabel::showRefusal);
    return field;
}

std::vector<std::size_t> RecolourDialog::chosen() const
{
    std::vector<std::size_t> uses;
    for (int row = 0; row < m_list->topLevelItemCount(); ++row)
        if (m_list->topLevelItem(row)->isSelected())
            uses.push_back(std::size_t(row));
    return uses;
}

void RecolourDialog::give(const Colour &colour)
{
    m_hint->showHint({});
    m_recolouring.set(chosen(), withOpacity(colour, 1));
    m_hex->showText(toOpaqueScreen(colour).name());
    showResults();
}

void RecolourDialog::takeHex(const QString &text)
{
    const std::optional<Colour> colour = typedColour(text);
    if (!colour) {
        m_hint->showRefusal(tr("“%1” is not a colour. Write it as #rrggbb, for example #2f6690.").arg(text));
        return showColour();
    }
    give(*colour);
    m_recolouring.rest();
    showColour();
}

void RecolourDialog::showColour()
{
    const std::vector<std::size_t> uses = chosen();
    for (QWidget *widget : std::initializer_list<QWidget *>{m_wheel, m_hex, m_swatches, m_reset})
        widget->setEnabled(!uses.empty());
    if (uses.empty())
        return;
    const Colour colour = m_recolouring.result(uses.front());
    m_wheel->setColour(colour);
    m_hex->showText(toOpaqueScreen(colour).name());
}

void RecolourDialog::showResults()
{
    for (int row = 0; row < m_list->topLevelItemCount(); ++row) {
        const Colour colour = m_recolouring.result(std::size_t(row));
        m_list->topLevelItem(row)->setIcon(AfterColumn, iconOf(colour, devicePixelRatioF()));
        m_list->topLevelItem(row)->setText(AfterColumn, toOpaqueScreen(colour).name());
    }
}

void RecolourDialog::setStepKeys(const QList<QKeySequence> &back, const QList<QKeySequence> &on)
{
    const auto connectKeys = [this](const QList<QKeySequence> &keys, bool isBack) {
        for (const QKeySequence &key : keys)
            connect(new QShortcut(key, this), &QShortcut::activated, this, [this, isBack] { step(isBack); });
    };
    connectKeys(back, true);
    connectKeys(on, false);
}

void RecolourDialog::step(bool back)
{
    m_recolouring.step(back);
    const QSignalBlocker keeps(m_keeps), maps(m_maps);
    m_keeps->setChecked(m_recolouring.keepsDifferences());
    m_maps->setChecked(m_recolouring.isMapped());
    m_hue->setValue(m_recolouring.shift().hue);
    m_saturation->setValue(m_recolouring.shift().saturation);
    m_lightness->setValue(m_recolouring.shift().lightness);
    m_hint->showHint({});
    showResults();
    showColour();
}

/// Return on a swatch means OK, as everywhere in a dialog; Space takes the swatch.
bool RecolourDialog::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_swatches && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            keyPressEvent(static_cast<QKeyEvent *>(event));
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

void RecolourDialog::accept()
{
    m_recolouring.accept();
    QDialog::accept();
}

void RecolourDialog::reject()
{
    m_recolouring.giveUp();
    QDialog::reject();
}

} // namespace suffuse
