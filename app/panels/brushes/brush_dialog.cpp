#include "app/panels/brushes/brush_dialog.h"

#include "app/session/editor.h"
#include "app/session/settings/brush_library.h"
#include "app/widgets/colour_swatch.h"
#include "app/widgets/mnemonics.h"
#include "app/widgets/quantity.h"
#include "app/widgets/response_editor.h"
#include "app/widgets/section.h"
#include "app/widgets/theme.h"
#include "model/paint/style_function.h"
#include "model/painting/validate.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QPainter>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

namespace suffuse {

namespace {

constexpr QSize pictureSize{520, 110};
constexpr int drawDelayMs = 30;

/// What a curve is when it is switched on: haste, distance and slant take away, the rest adds.
ResponseCurve usualCurve(BrushInput input)
{
    switch (input) {
    case BrushInput::Pressure:
        return {{{0, 0.2f}, {1, 1}}};
    case BrushInput::StrokeRandom:
    case BrushInput::Drift:
        return {{{0, 0.5f}, {1, 1}}};
    default:
        return {{{0, 1}, {1, 0.5f}}};
    }
}

Style usualStyle(StyleKind kind)
{
    if (kind == StyleKind::Feathering)
        return {kind, {1, 1.2f, 0}};
    if (kind == StyleKind::Edge)
        return {kind, {0.5f, 0.5f, 0.4f}};
    return {kind, {0.5f, 0.05f, 0}};
}

} // namespace

BrushDialog::BrushDialog(Editor &editor, QWidget *parent) : QDialog(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(12, 12, 12, 12);
    column->setSpacing(10);
    m_picture = new QLabel(this);
    m_picture->setFixedSize(pictureSize);
    m_picture->setAccessibleName(tr("A stroke of the brush"));
    column->addWidget(m_picture, 0, Qt::AlignHCenter);
    auto *tabs = new QTabWidget(this);
    tabs->addTab(makePaintPage(), tr("Paint"));
    tabs->addTab(makeCurvesPage(), tr("Curves"));
    tabs->addTab(makeColourPage(), tr("Colour"));
    tabs->addTab(makeHandPage(), tr("Shape and hand"));
    tabs->setAccessibleName(tr("Settings of the brush"));
    column->addWidget(tabs, 1);
    alignFieldLabels(*tabs);
    m_hint = new HintLabel(this);
    column->addWidget(m_hint);
    addButtons(*column);
    for (const Bound &b : m_bound)
        connect(b.field, &SliderField::refused, m_hint, &HintLabel::showRefusal);
    m_drawSoon.setSingleShot(true);
    m_drawSoon.setInterval(drawDelayMs);
    connect(&m_drawSoon, &QTimer::timeout, this, &BrushDialog::drawPreview);
    connect(&editor, &Editor::brushChanged, this, &BrushDialog::refresh);
    connect(&BrushLibrary::instance(), &BrushLibrary::changed, this, &BrushDialog::refresh);
    refresh();
}

void BrushDialog::addButtons(QVBoxLayout &column)
{
    auto *row = new QHBoxLayout;
    m_save = new QPushButton(tr("&Save Changes"), this);
    m_save->setToolTip(tr("Keeps the changes in the brush of this name; built-in brushes stay as they are"));
    auto *saveAsNew = new QPushButton(tr("Save as &New…"), this);
    saveAsNew->setToolTip(tr("Keeps the brush under another name"));
    auto *shut = new QPushButton(tr("&Close"), this);
    shut->setToolTip(tr("Closes this window; the brush stays in hand as it is"));
    for (QPushButton *button : {m_save, saveAsNew, shut})
        button->setAutoDefault(false); // Return in a field is no press
    row->addWidget(m_save);
    row->addWidget(saveAsNew);
    row->addStretch();
    row->addWidget(shut);
    column.addLayout(row);
    connect(m_save, &QPushButton::clicked, this, &BrushDialog::saveWanted);
    connect(saveAsNew, &QPushButton::clicked, this, &BrushDialog::saveAsNewWanted);
    connect(shut, &QPushButton::clicked, this, &BrushDialog::close);
}

QWidget *BrushDialog::makePage(QVBoxLayout *&column)
{
    auto *page = new QWidget(this);
    column = new QVBoxLayout(page);
    column->setContentsMargins(12, 12, 12, 12);
    column->setSpacing(8);
    return page;
}

void BrushDialog::bind(QGridLayout &grid, const FieldSpec &spec, const Get &get, const Set &set)
{
    auto *field = new SliderField(spec, grid, grid.rowCount(), this);
    m_bound.push_back({field, spec.name, get});
    connect(field, &SliderField::edited, this, [=, this](double value) { change([&](Brush &b) { set(b, value); }); });
}

SliderField *BrushDialog::field(const QString &name) const
{
    for (const Bound &b : m_bound)
        if (b.name == name)
            return b.field;
    return nullptr;
}

void BrushDialog::change(const std::function<void(Brush &)> &apply)
{
    Brush brush = m_editor.brush();
    apply(brush);
    const QString problem = problemOf(brush);
    m_hint->showHint(problem);
    if (problem.isEmpty())
        m_editor.setBrush(brush);
    else
        refresh();
}

void BrushDialog::chooseStyle(int kind)
{
    if (StyleKind(kind) != m_editor.brush().style.kind)
        change([=](Brush &b) { b.style = usualStyle(StyleKind(kind)); });
}

void BrushDialog::cellChanged(QTableWidgetItem *item)
{
    const auto quantity = BrushQuantity(item->row());
    const auto input = BrushInput(item->column());
    const bool on = item->checkState() == Qt::Checked;
    if (on == (m_editor.brush().curve(quantity, input) != nullptr))
        return;
    m_curves->setCurrentItem(item);
    change([=](Brush &b) { on ? b.setCurve(quantity, input, usualCurve(input)) : b.removeCurve(quantity, input); });
}

void BrushDialog::showCell()
{
    const int q = m_curves->currentRow(), i = m_curves->currentColumn();
    const ResponseCurve *curve = m_editor.brush().curve(BrushQuantity(q), BrushInput(i));
    m_curve->setEnabled(curve != nullptr);
    // Curves multiply ω; shown is the grain, which grows as ω falls.
    m_curve->setUpsideDown(BrushQuantity(q) == BrushQuantity::Granulation);
    m_curve->setTexts(m_curves->verticalHeaderItem(q)->text(), {}, m_curves->horizontalHeaderItem(i)->text());
    m_curve->setCurve(curve ? *curve : ResponseCurve{{{0, 1}, {1, 1}}});
}

void BrushDialog::refresh()
{
    const Brush &brush = m_editor.brush();
    const Brush *preset = BrushLibrary::instance().find(brush.name);
    m_save->setEnabled(BrushLibrary::instance().isOwn(brush.name) && !isSameBrush(brush, *preset));
    setWindowTitle(tr("Brush: %1").arg(brushTitle(brush.name)));
    for (const Bound &b : m_bound)
        b.field->setValue(b.get(brush));
    m_style->setCurrentIndex(int(brush.style.kind));
    m_mix->setCurrentIndex(int(brush.mix.mode));
    for (std::size_t i = 0; i < m_xi.size(); ++i) {
        const FieldSpec spec = xiSpec(brush.style.kind, int(i));
        if (m_xi[i]->number()->accessibleName() != spec.name)
            m_xi[i]->rename(spec.name, spec.toolTip);
    }
    giveMnemonics(*this);
    m_xi[2]->setVisible(xiCount(brush.style.kind) > 2);
    m_beta->setVisible(brush.mix.mode == MixMode::Beta);
    m_stabiliser->setCurrentIndex(int(brush.stabiliser.kind));
    m_strength->setVisible(brush.stabiliser.kind == Stabiliser::Kind::Weighted);
    m_string->setVisible(brush.stabiliser.kind == Stabiliser::Kind::String);
    m_followsPath->setChecked(brush.tip.followsPath);
    m_jitterAlong->setChecked(brush.jitter.along);
    m_second->setColour(brush.secondColour);
    const QSignalBlocker blocker(m_curves);
    for (int q = 0; q < brushQuantities; ++q)
        for (int i = 0; i < brushInputs; ++i)
            m_curves->item(q, i)->setCheckState(brush.curve(BrushQuantity(q), BrushInput(i)) ? Qt::Checked
                                                                                             : Qt::Unchecked);
    showCell();
    m_drawSoon.start();
}

void BrushDialog::changeEvent(QEvent *event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::ApplicationPaletteChange)
        m_drawSoon.start(); // its paper is the theme's
}

void BrushDialog::drawPreview()
{
    const double ratio = devicePixelRatioF();
    m_image = m_preview.render(m_editor.brush(), pictureSize * ratio);
    QPixmap pixmap(pictureSize * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(paperFor(m_image));
    QPainter painter(&pixmap);
    if (!m_image.isNull())
        painter.drawImage(QRectF(QPointF(), QSizeF(pictureSize)), m_image);
    painter.setPen(hairline());
    painter.drawRect(QRectF(0.5, 0.5, pictureSize.width() - 1, pictureSize.height() - 1));
    painter.end();
    m_picture->setPixmap(pixmap);
}

} // namespace suffuse
