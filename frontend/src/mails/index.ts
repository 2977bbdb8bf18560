export { mailedLinksQuery } from './api'
export { MailedLink } from './MailedLink'
