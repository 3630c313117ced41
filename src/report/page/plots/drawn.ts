/** What is being drawn, and where. */
import type uPlot from 'uplot';
import type { Box } from './paths';
import type { Screen } from './screen';
import type { Style } from './style';
import type { Plot, Series } from '../data';

export interface Drawn {
  series: Series;
  style: Style;
  screen: Screen;
}

export interface Canvas {
  u: uPlot;
  context: CanvasRenderingContext2D;
  plot: Plot;
  /** canvas pixels to a pixel of the page */
  unit: number;
  /** the plotting area, canvas pixels */
  box: Box;
}
