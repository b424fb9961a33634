#include "app/widgets/brush/brush_combo.h"

#include "app/session/settings/brush_library.h"
#include "app/widgets/brush/brush_grid.h"
#include "app/widgets/brush/brush_pictures.h"
#include "app/widgets/habits/place_beside.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QScreen>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace suffuse {

namespace {

constexpr int columns = 4;
constexpr double rowsSeen = 6.5; ///< a cut row says that there are more
constexpr QSize chip{48, 19};    ///< the picture in the closed box
constexpr int gap = 6;

} // namespace

BrushCombo::BrushCombo(QWidget *parent) : QComboBox(parent)
{
    connect(&BrushPictures::instance(), &BrushPictures::drawn, this, [this](const QString &name) {
        if (name == currentData().toString())
            update();
    });
}

void BrushCombo::fill()
{
    clear();
    for (const Brush &brush : BrushLibrary::instance().brushes())
        addItem(brushTitle(brush.name), brush.name);
    if (m_grid)
        filter();
    if (m_started)
        BrushPictures::instance().want(devicePixelRatioF());
    updateGeometry();
}

QSize BrushCombo::sizeHint() const
{
    int widest = 0;
    for (int i = 0; i < count(); ++i)
        widest = std::max(widest, fontMetrics().horizontalAdvance(itemText(i)));
    return sizeFor(widest);
}

QSize BrushCombo::minimumSizeHint() const
{
    constexpr int characters = 6;
    return sizeFor(std::min(characters * fontMetrics().averageCharWidth(), sizeHint().width()));
}

/// With room for so wide a name.
QSize BrushCombo::sizeFor(int name) const
{
    QStyleOptionComboBox option;
    initStyleOption(&option);
    const QSize inner(chip.width() + gap + name + gap, std::max(chip.height(), fontMetrics().height()) + 2);
    return style()->sizeFromContents(QStyle::CT_ComboBox, &option, inner, this);
}

void BrushCombo::paintEvent(QPaintEvent *)
{
    if (!std::exchange(m_started, true))
        BrushPictures::instance().want(devicePixelRatioF());
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    const QRect room = style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    QRect text = room.adjusted(2, 0, 0, 0);
    if (currentIndex() >= 0) {
        const QRect at = QStyle::alignedRect(layoutDirection(), Qt::AlignLeft | Qt::AlignVCenter, chip, text);
        painter.drawPixmap(at, BrushPictures::instance().sheet(currentData().toString(), chip, devicePixelRatioF()));
        text.setLeft(at.right() + gap);
    }
    painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::ButtonText));
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(currentIndex() >= 0 ? currentText() : placeholderText(), Qt::ElideRight,
                                              text.width()));
}

void BrushCombo::changeEvent(QEvent *event)
{
    QComboBox::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        updateGeometry();
}

BrushGrid *BrushCombo::grid() const
{
    return m_popup && m_popup->isVisible() ? m_grid : nullptr;
}

void BrushCombo::makePopup()
{
    m_popup = new QFrame(this, Qt::Popup);
    m_popup->setFrameShape(QFrame::StyledPanel);
    m_popup->setWindowTitle(accessibleName());
    auto *column = new QVBoxLayout(m_popup);
    column->setContentsMargins(6, 6, 6, 6);
    m_search = new QLineEdit(m_popup);
    m_search->setPlaceholderText(tr("Search"));
    m_search->setAccessibleName(tr("Search brushes"));
    m_search->setClearButtonEnabled(true);
    m_grid = new BrushGrid(m_popup);
    column->addWidget(m_search);
    column->addWidget(m_grid, 1);
    for (QWidget *part : {static_cast<QWidget *>(m_search), static_cast<QWidget *>(m_grid)})
        part->installEventFilter(this);
    connect(m_search, &QLineEdit::textChanged, this, &BrushCombo::filter);
    connect(m_grid, &QListWidget::itemClicked, this,
            [this](const QListWidgetItem *item) { choose(BrushGrid::brushOf(item)); });
}

void BrushCombo::filter()
{
    const QString text = m_search->text();
    m_grid->fillGroups([&text](const Brush &brush) { return isBrushCalled(brush, text); }, text);
    if (text.trimmed().isEmpty())
        m_grid->mark(currentData().toString());
    else
        m_grid->showFirst();
}

void BrushCombo::showPopup()
{
    if (!m_popup)
        makePopup();
    m_search->clear();
    filter();
    placePopup();
    m_popup->show();
    m_grid->setFocus(Qt::PopupFocusReason);
    m_grid->scrollToItem(m_grid->currentItem(), QAbstractItemView::PositionAtCenter);
}

void BrushCombo::placePopup()
{
    const QSize list = m_grid->sizeFor(columns, 1);
    m_popup->ensurePolished();
    const QMargins margins = m_popup->layout()->contentsMargins();
    const int cell = list.height();
    const QRect box(mapToGlobal(QPoint()), size()), room = screen()->availableGeometry();
    const int wanted = int(rowsSeen * cell) + m_search->sizeHint().height() + 3 * margins.top();
    const int below = room.bottom() - box.bottom(), above = box.top() - room.top();
    const bool down = below >= wanted || below >= above;
    const QSize size(list.width() + margins.left() + margins.right() + 2 * m_popup->frameWidth(),
                     std::min(wanted, down ? below : above));
    const QPoint corner(box.left(), down ? box.bottom() + 1 : box.top() - size.height());
    m_popup->setGeometry(placeWithin({corner, size}, room));
}

void BrushCombo::hidePopup()
{
    if (m_popup)
        m_popup->hide();
    QComboBox::hidePopup();
}

void BrushCombo::choose(const QString &name)
{
    const int index = findData(name);
    if (name.isEmpty() || index < 0)
        return;
    hidePopup();
    setCurrentIndex(index);
    emit activated(index);
}

/// Return chooses from the search, too, and the arrow keys go from it into the list.
bool BrushCombo::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress)
        return QComboBox::eventFilter(watched, event);
    const auto *key = static_cast<QKeyEvent *>(event);
    switch (key->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        choose(BrushGrid::brushOf(m_grid->currentItem()));
        return true;
    case Qt::Key_Escape:
        hidePopup();
        return true;
    case Qt::Key_Down:
        if (watched == m_search) {
            m_grid->setFocus(Qt::TabFocusReason);
            return true;
        }
        break;
    default:
        if (watched == m_grid && !key->text().isEmpty() && key->text()[0].isLetterOrNumber()) {
            m_search->setFocus(Qt::ShortcutFocusReason);
            m_search->insert(key->text());
            return true;
        }
        break;
    }
    return QComboBox::eventFilter(watched, event);
}

} // namespace suffuse
