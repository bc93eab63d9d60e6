// Asks before everything is forgotten, since nothing can be brought back.
import { type Acts, byId } from '../elements';

export function forgetActs(forget: () => Promise<void>): Acts {
  const question = byId('forget-question');
  const asks = () => document.querySelector<HTMLElement>('[data-act="forget"]');
  const show = (shown: boolean) => {
    question.hidden = !shown;
    asks()?.setAttribute('aria-expanded', String(shown));
    // The focus is on the answer that loses nothing.
    (shown ? question.querySelector<HTMLElement>('[data-act="forget-not"]') : asks())?.focus();
  };
  question.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') show(false);
  });
  return {
    forget: () => show(question.hidden),
    'forget-not': () => show(false),
    'forget-now': forget,
  };
}
