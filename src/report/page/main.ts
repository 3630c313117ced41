/** The page of a report: reads what it is told and builds itself. */
import 'uplot/dist/uPlot.min.css';
import './page.css';
import './table.css';
import './plots/plots.css';
import './print.css';
import { buildPage } from './layout';
import { tellProblem, watchProblems } from './problems';
import { watchPrint } from './print';
import type { PageData } from './data';

watchProblems();
try {
  const text = document.getElementById('page-data')?.textContent;
  if (!text) throw new Error('the data of the page are missing: the file is not whole');
  buildPage(JSON.parse(text) as PageData, document.body);
  watchPrint();
} catch (error) {
  tellProblem(error);
}
