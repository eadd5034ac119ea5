'use strict';
// Puts the runs in the order of one of their values: of numbers by size, of words by their letters, empty ones last.
const runs = document.getElementById('runs');
const order = document.getElementById('order');
const down = document.getElementById('down');
const cards = [...runs.children];

function valueOf(card, column) {
  if (column === 0) return String(cards.indexOf(card) + 1);
  return card.querySelectorAll('dd')[column - 1].title;
}

function compare(a, b) {
  if (a === '' || b === '') return a === b ? 0 : a === '' ? 1 : -1;
  const sign = down.checked ? -1 : 1;
  const isNumeric = !isNaN(a) && !isNaN(b);
  return sign * (isNumeric ? Number(a) - Number(b) : a < b ? -1 : a > b ? 1 : 0);
}

function sort() {
  const column = Number(order.value);
  runs.append(...[...cards].sort((a, b) => compare(valueOf(a, column), valueOf(b, column))));
}

order.addEventListener('change', sort);
down.addEventListener('change', sort);
