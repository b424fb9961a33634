#include "app/panels/brushes/brush_dialog.h"

#include "app/panels/brushes/brush_colour_page.h"
#include "app/panels/brushes/brush_curves_page.h"
#include "app/panels/brushes/brush_hand_page.h"
#include "app/panels/brushes/brush_paint_page.h"
#include "app/session/editor.h"
#include "app/session/settings/brush_library.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/section.h"
#include "app/widgets/look/theme.h"
#include "model/painting/validate.h"

#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

namespace suffuse {

namespace {

constexpr QSize previewSize{520, 110};
constexpr int drawDelayMs = 30;

} // namespace

BrushDialog::BrushDialog(Editor &editor, QWidget *parent) : QDialog(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(12, 12, 12, 12);
    column->setSpacing(10);
    m_picture = new QLabel(this);
    m_picture->setFixedSize(previewSize);
    m_picture->setAccessibleName(tr("A stroke of the brush"));
    column->addWidget(m_picture, 0, Qt::AlignHCenter);
    auto *tabs = new QTabWidget(this);
    m_paint = new BrushPaintPage(this);
    m_curves = new BrushCurvesPage(this);
    m_pages = {m_paint, m_curves, new BrushColourPage(this), new BrushHandPage(this)};
    tabs->addTab(m_pages[0], tr("Paint"));
    tabs->addTab(m_pages[1], tr("Curves"));
    tabs->addTab(m_pages[2], tr("Colour"));
    tabs->addTab(m_pages[3], tr("Shape and hand"));
    tabs->setAccessibleName(tr("Settings of the brush"));
    column->addWidget(tabs, 1);
    alignFieldLabels(*tabs);
    m_hint = new HintLabel(this);
    column->addWidget(m_hint);
    addButtons(*column);
    for (const BrushPage *page : m_pages) {
        connect(page, &BrushPage::changed, this, &BrushDialog::change);
        connect(page, &BrushPage::refused, m_hint, &HintLabel::showRefusal);
    }
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
    for (QPushButton *button : findChildren<QPushButton *>())
        button->setAutoDefault(false); // Return in a field must not press a button, the pages' neither.
    row->addWidget(m_save);
    row->addWidget(saveAsNew);
    row->addStretch();
    row->addWidget(shut);
    column.addLayout(row);
    connect(m_save, &QPushButton::clicked, this, &BrushDialog::saveWanted);
    connect(saveAsNew, &QPushButton::clicked, this, &BrushDialog::saveAsNewWanted);
    connect(shut, &QPushButton::clicked, this, &BrushDialog::close);
}

SliderField *BrushDialog::field(const QString &name) const
{
    for (const BrushPage *page : m_pages)
        if (SliderField *field = page->field(name))
            return field;
    return nullptr;
}

QTableWidget *BrushDialog::curves() const
{
    return m_curves->curves();
}

ResponseEditor *BrushDialog::curve() const
{
    return m_curves->curve();
}

QComboBox *BrushDialog::style() const
{
    return m_paint->style();
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

void BrushDialog::refresh()
{
    const Brush &brush = m_editor.brush();
    const BrushLibrary &library = BrushLibrary::instance();
    m_save->setEnabled(library.isOwn(brush.name) && library.isChanged(brush));
    setWindowTitle(tr("Brush: %1").arg(brushTitle(brush.name)));
    setHelpPage(*this, "brushes");
    for (BrushPage *page : m_pages)
        page->showBrush(brush);
    giveMnemonics(*this);
    m_drawSoon.start();
}

void BrushDialog::changeEvent(QEvent *event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::ApplicationPaletteChange)
        m_drawSoon.start(); // The stroke is painted on paper of the theme's colour.
}

void BrushDialog::drawPreview()
{
    const double ratio = devicePixelRatioF();
    m_image = m_preview.render(m_editor.brush(), previewSize * ratio);
    QPixmap pixmap(previewSize * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(paperFor(m_image));
    QPainter painter(&pixmap);
    if (!m_image.isNull())
        painter.drawImage(QRectF(QPointF(), QSizeF(previewSize)), m_image);
    painter.setPen(hairline());
    painter.drawRect(QRectF(0.5, 0.5, previewSize.width() - 1, previewSize.height() - 1));
    painter.end();
    m_picture->setPixmap(pixmap);
}

} // namespace suffuse
