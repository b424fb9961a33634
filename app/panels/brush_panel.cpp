#include "app/panels/brush_panel.h"

#include "app/editor.h"
#include "app/icons.h"
#include "app/panels/section.h"
#include "app/panels/slider_field.h"
#include "app/theme.h"
#include "model/validate.h"

#include <QApplication>
#include <QEvent>
#include <QGridLayout>
#include <QListWidget>
#include <QPainter>
#include <QPainterPath>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

namespace suffuse {

namespace {

constexpr QSize previewSize{112, 44};

QPixmap onPaper(const QImage &stroke, double ratio, bool chosen)
{
    QPixmap pixmap(previewSize * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath sheet;
    sheet.addRoundedRect(QRectF(0.5, 0.5, previewSize.width() - 1, previewSize.height() - 1), 4, 4);
    painter.fillPath(sheet, previewPaper());
    if (!stroke.isNull()) {
        painter.setClipPath(sheet);
        painter.drawImage(QRectF(QPointF(), QSizeF(previewSize)), stroke);
        painter.setClipping(false);
    }
    painter.strokePath(sheet,
                       chosen ? QPen(QApplication::palette().color(QPalette::Highlight), 4) : QPen(hairline(), 1));
    return pixmap;
}

/// The chosen one gets a frame, not a tint over its colours.
QIcon previewIcon(const QImage &stroke, double ratio)
{
    QIcon result(onPaper(stroke, ratio, false));
    result.addPixmap(onPaper(stroke, ratio, true), QIcon::Selected);
    return result;
}

} // namespace

BrushPanel::BrushPanel(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    m_list = new QListWidget(this);
    m_list->setViewMode(QListView::IconMode);
    m_list->setMovement(QListView::Static);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setUniformItemSizes(true);
    m_list->setIconSize(previewSize);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setAccessibleName(tr("Brushes"));
    m_list->setToolTip(tr("Choose what to paint with. The colour stays."));
    m_list->viewport()->setAutoFillBackground(false);
    column->addWidget(m_list, 1);
    fillList();
    addFields(*column);
    m_hint = new HintLabel(this);
    column->addWidget(m_hint);
    for (SliderField *field : {m_size, m_flow, m_opacity})
        connect(field, &SliderField::refused, m_hint, &HintLabel::showHint);
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem *item) {
        if (item)
            choose(item->data(Qt::UserRole).toString());
    });
    connect(&editor, &Editor::brushChanged, this, &BrushPanel::refresh);
    refresh();
}

QSize BrushPanel::sizeHint() const
{
    return {280, 320};
}

void BrushPanel::fillList()
{
    for (const Brush &brush : builtinBrushes()) {
        auto *item = new QListWidgetItem(previewIcon({}, devicePixelRatioF()), brushTitle(brush.name), m_list);
        item->setData(Qt::UserRole, brush.name);
        item->setToolTip(tr("%1: spread %2 units, dry after %3 s")
                             .arg(brushTitle(brush.name), QLocale().toString(brush.spread(), 'f', 1),
                                  QLocale().toString(brush.maxAge, 'g', 3)));
        item->setSizeHint({previewSize.width() + 6, previewSize.height() + fontMetrics().height() + 10});
    }
}

void BrushPanel::addFields(QVBoxLayout &column)
{
    auto *head = new QHBoxLayout;
    m_title = sectionTitle(QString(), this);
    m_reset = new QToolButton(this);
    m_reset->setIcon(icon("reset"));
    m_reset->setAutoRaise(true);
    m_reset->setAccessibleName(tr("Reset brush"));
    m_reset->setToolTip(tr("Back to the brush as it came"));
    head->addWidget(m_title, 1);
    head->addWidget(m_reset);
    column.addLayout(head);
    connect(m_reset, &QToolButton::clicked, this, [this] { choose(m_editor.brush().name); });

    QGridLayout *grid = addFieldGrid(column);
    m_size = new SliderField({.name = tr("Size"),
                              .toolTip = tr("How far the paint spreads, in units; sets the diffusion."),
                              .unit = QStringLiteral(" u"),
                              .minimum = 0.01,
                              .maximum = 1e5,
                              .sliderMinimum = 0.5,
                              .sliderMaximum = 300,
                              .logarithmic = true,
                              .defaultValue = Brush{}.spread()},
                             *grid, 0, this);
    m_flow = new SliderField({.name = tr("Flow"),
                              .toolTip = tr("Density in the middle of the stroke at full pressure."),
                              .minimum = 0.001,
                              .maximum = 1e6,
                              .sliderMinimum = 0.1,
                              .sliderMaximum = 10,
                              .logarithmic = true,
                              .defaultValue = Brush{}.peak},
                             *grid, 1, this);
    m_opacity = new SliderField({.name = tr("Opacity"),
                                 .toolTip = tr("How much the paint covers at full density"),
                                 .unit = QStringLiteral(" %"),
                                 .factor = 100,
                                 .step = 0.01,
                                 .defaultValue = 1},
                                *grid, 2, this);
    connect(m_size, &SliderField::edited, this, [this](double spread) {
        edit([=](Brush &b) { b.diffusion = float(spread * spread / (4 * double(b.maxAge))); });
    });
    connect(m_flow, &SliderField::edited, this, [this](double peak) { edit([=](Brush &b) { b.peak = float(peak); }); });
    connect(m_opacity, &SliderField::edited, this,
            [this](double opacity) { edit([=](Brush &b) { b.colour.opacity = float(opacity); }); });
}

void BrushPanel::choose(const QString &id)
{
    const Brush *preset = findBrush(id);
    if (!preset)
        return;
    Brush brush = *preset;
    const Colour &current = m_editor.brush().colour;
    brush.colour = {current.red, current.yellow, current.blue, preset->colour.opacity};
    m_editor.setBrush(brush);
}

void BrushPanel::edit(const std::function<void(Brush &)> &change)
{
    Brush brush = m_editor.brush();
    change(brush);
    m_hint->showHint({});
    m_editor.setBrush(brush);
}

bool BrushPanel::isModified() const
{
    const Brush *preset = findBrush(m_editor.brush().name);
    if (!preset)
        return false;
    Brush plain = m_editor.brush();
    const float opacity = plain.colour.opacity;
    plain.colour = preset->colour;
    plain.colour.opacity = opacity;
    return !(plain == *preset);
}

void BrushPanel::refresh()
{
    const Brush &brush = m_editor.brush();
    const QSignalBlocker blocker(m_list);
    for (int row = 0; row < m_list->count(); ++row)
        if (m_list->item(row)->data(Qt::UserRole).toString() == brush.name)
            m_list->setCurrentRow(row);
    const bool modified = isModified();
    m_title->setText(modified ? tr("%1 (changed)").arg(brushTitle(brush.name)) : brushTitle(brush.name));
    m_reset->setEnabled(modified);
    if (const Brush *preset = findBrush(brush.name)) {
        m_size->setDefaultValue(preset->spread());
        m_flow->setDefaultValue(double(preset->peak));
        m_opacity->setDefaultValue(double(preset->colour.opacity));
    }
    m_size->setValue(brush.spread());
    m_flow->setValue(double(brush.peak));
    m_opacity->setValue(double(brush.colour.opacity));
}

void BrushPanel::paintEvent(QPaintEvent *event)
{
    QWidget::paintEvent(event);
    if (m_started)
        return;
    // Pictures come after the first paint, one at a time: the window is there at once.
    m_started = true;
    schedulePreviews();
}

void BrushPanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::ApplicationPaletteChange && m_started)
        schedulePreviews();
}

void BrushPanel::schedulePreviews()
{
    const bool idle = m_pending.empty();
    m_pending.clear();
    for (int row = m_list->count() - 1; row >= 0; --row)
        m_pending.push_back(row);
    if (idle && !m_pending.empty())
        QTimer::singleShot(0, this, &BrushPanel::renderNext);
}

void BrushPanel::renderNext()
{
    if (m_pending.empty())
        return;
    QListWidgetItem *item = m_list->item(m_pending.back());
    m_pending.pop_back();
    if (const Brush *brush = findBrush(item->data(Qt::UserRole).toString())) {
        const double ratio = devicePixelRatioF();
        item->setIcon(previewIcon(m_preview.render(*brush, previewSize * ratio), ratio));
    }
    if (!m_pending.empty())
        QTimer::singleShot(0, this, &BrushPanel::renderNext);
}

} // namespace suffuse
